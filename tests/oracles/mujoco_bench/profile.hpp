// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tests/oracles/mujoco_bench/draws.hpp"

namespace torquewright::oracles::mujoco_bench {

/// What is played in one run: within [-1, 1] times amplitude, plus offset.
struct Profile {
  struct Sine {
    double share, hz, phase_rad;
  };
  std::string kind = "constant";  // constant, steps, triangle, chirp, sines
  double amplitude = 0, offset = 0;
  double period_s = 1, first_hz = 0.1, last_hz = 1, duration_s = 10;
  std::vector<double> levels = {};
  std::vector<Sine> sines = {};

  double operator()(double time_s) const;
};

Profile constant(double level);
/// Levels of both signs, each held for `period_s`, joined by ramps.
Profile steps(Draws& draws, double amplitude, double period_s, double duration_s);
Profile triangle(double amplitude, double period_s);
Profile chirp(double amplitude, double first_hz, double last_hz, double duration_s);
Profile sines(Draws& draws, double amplitude, double first_hz, double last_hz, int count);
/// A fundamental and three harmonics.
Profile gait(Draws& draws, double amplitude, double hz);

}  // namespace torquewright::oracles::mujoco_bench
