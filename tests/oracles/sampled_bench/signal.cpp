// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/sampled_bench/signal.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace torquewright::oracles::sampled {
namespace {

double smooth_step(double share) {
  const double x = std::clamp(share, 0.0, 1.0);
  return x * x * x * (10.0 + x * (6.0 * x - 15.0));
}

double level_at(const std::vector<Level>& levels, double time_s) {
  const auto after = std::upper_bound(levels.begin(), levels.end(), time_s,
                                      [](double t, const Level& one) { return t < one.time_s; });
  if (after == levels.begin()) return 0.0;
  const Level& now = *std::prev(after);
  const double before = std::prev(after) == levels.begin() ? 0.0 : std::prev(after, 2)->value;
  return before + (now.value - before) * smooth_step((time_s - now.time_s) / now.rise_s);
}

double chirp_at(const Chirp& one, double time_s) {
  const double sweep_hz_s = (one.last_hz - one.first_hz) / one.duration_s;
  const double turns = (one.first_hz + 0.5 * sweep_hz_s * time_s) * time_s;
  return one.amplitude * std::sin(2.0 * std::numbers::pi * turns);
}

}  // namespace

double Signal::at(double time_s) const {
  double value = constant + level_at(levels, time_s);
  for (const Sine& one : sines) {
    value += one.amplitude *
             std::sin(2.0 * std::numbers::pi * one.frequency_hz * time_s + one.phase_rad);
  }
  for (const Chirp& one : chirps) value += chirp_at(one, time_s);
  return value;
}

double Signal::rate(double time_s) const {
  constexpr double kDelta_s = 1e-4;  // central difference: content ends at some 20 Hz
  return (at(time_s + kDelta_s) - at(time_s - kDelta_s)) / (2.0 * kDelta_s);
}

}  // namespace torquewright::oracles::sampled
