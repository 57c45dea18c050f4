// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace torquewright::identification {

/// The unfiltered position that a velocity was derived from, with its noise.
struct PositionSamples {
  double deviation_rad = 0.0;  ///< Standard deviation of its white noise.
  double cutoff_Hz = 0.0;      ///< Cut-off of the low-pass that the velocity has passed.
  double step_s = 0.0;
};

/// Returns the velocity below another cut-off, from the unfiltered position.
std::vector<double> velocity_below(double cutoff_Hz, const std::vector<double>& unfiltered_rad,
                                   double step_s);

/// Returns the sign of the motion at each sample, from the unfiltered position where there is one
/// (see mean_signs).
std::vector<double> directions(const std::vector<double>& velocity_rad_s,
                               const std::vector<double>& unfiltered_rad,
                               const PositionSamples& samples);

}  // namespace torquewright::identification
