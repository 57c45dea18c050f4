// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace torquewright::identification {

/// The unfiltered channel that tells the motion, with its noise: a position, or a speed.
struct RawMotion {
  std::vector<double> values;  ///< Empty: no wider band is known.
  bool is_speed = false;
  double deviation = 0.0;  ///< Standard deviation of its white noise.
  double step_s = 0.0;

  /// Returns the speed below a cut-off.
  std::vector<double> speed_below(double cutoff_Hz) const;
  /// Returns the standard deviation of that speed's noise.
  double speed_noise(double cutoff_Hz) const;
  /// Returns the widest of a cut-off and its half, quarter and eighth in which the motion stands
  /// out of the noise: kBeyondNoise deviations are less than a quarter of the speed that 5 % of the
  /// samples exceed. Where it never does, or no unfiltered channel is known, the cut-off itself.
  double seen_below_Hz(double cutoff_Hz) const;
};

/// Returns the sign of the motion at each sample, from the unfiltered channel where there is one
/// (see mean_signs). `cutoff_Hz` is of the low-pass that the speed has passed.
std::vector<double> directions(const std::vector<double>& speed_rad_s, const RawMotion& raw,
                               double cutoff_Hz);

}  // namespace torquewright::identification
