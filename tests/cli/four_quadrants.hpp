// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

namespace torquewright::cli_test {

/// Amplitude, frequency in Hz and phase in rad of a sine, whose phase each run shifts again.
using Sines = std::array<std::array<double, 3>, 3>;

inline double sum_of_sines(const Sines& sines, double t_s, double run) {
  double sum = 0.0;
  for (const auto& [amplitude, frequency_Hz, phase_rad] : sines) {
    sum += amplitude * std::sin(2.0 * std::numbers::pi * frequency_Hz * t_s + phase_rad * run);
  }
  return sum;
}

/// What a dynamometer plays in four runs of so many rows, 5 ms apart: speed, at up to 6.3 rad/s
/// times the scale, and current of different frequencies, so that all quadrants are met.
inline std::string four_quadrants(std::size_t rows_per_run, double speed_scale) {
  constexpr Sines kCurrent_A{{{8.0, 0.23, 1.1}, {6.0, 0.57, 0.3}, {4.0, 1.9, 2.2}}};
  constexpr Sines kSpeed_rad_s{{{4.0, 0.15, 0.4}, {1.5, 0.71, 1.7}, {0.8, 1.3, 2.9}}};
  std::string text = "time_s,motor_current_A,output_velocity_rad_s,run\n";
  for (int run = 1; run <= 4; ++run) {
    for (std::size_t k = 0; k < rows_per_run; ++k) {
      const double t_s = 0.005 * static_cast<double>(k);
      text += fmt::format("{:.6g},{:.6g},{:.6g},run_{}\n", t_s, sum_of_sines(kCurrent_A, t_s, run),
                          speed_scale * sum_of_sines(kSpeed_rad_s, t_s, run), run);
    }
  }
  return text;
}

}  // namespace torquewright::cli_test
