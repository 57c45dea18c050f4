// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace torquewright::oracles::sampled {

struct Sine {
  double amplitude, frequency_hz, phase_rad;
};
struct Chirp {
  double amplitude, first_hz, last_hz, duration_s;
};
/// From `time_s` on the level; the change takes `rise_s` and is smooth to the second derivative.
struct Level {
  double time_s, value, rise_s;
};

/// A smooth course over time: the sum of its parts.
struct Signal {
  double constant = 0.0;
  std::vector<Sine> sines;
  std::vector<Chirp> chirps;
  std::vector<Level> levels;

  double at(double time_s) const;
  double rate(double time_s) const;
};

}  // namespace torquewright::oracles::sampled
