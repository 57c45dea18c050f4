// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace torquewright::identification {

/// What is known of the position that a velocity was derived from.
struct PositionSamples {
  double deviation_rad = 0.0;  ///< Of its white noise.
  double cutoff_Hz = 0.0;      ///< Of the low-pass that the velocity has passed.
  double step_s = 0.0;
};

/// The velocity below another cut-off, of the unfiltered position.
std::vector<double> velocity_below(double cutoff_Hz, const std::vector<double>& unfiltered_rad,
                                   double step_s);

/// The sign of the motion at each sample, by the unfiltered position where there is one: see
/// mean_signs.
std::vector<double> directions(const std::vector<double>& velocity_rad_s,
                               const std::vector<double>& unfiltered_rad,
                               const PositionSamples& samples);

}  // namespace torquewright::identification
