// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

namespace torquewright::identification {

/// Standard deviations of its noise beyond which a channel is known in a band of several that are
/// asked. A choice of ours.
constexpr double kBeyondNoise = 4.0;

/// A channel in wider bands than that of its low-pass.
struct Bands {
  /// Returns the channel below a cut-off; empty: no wider band is known.
  std::function<std::vector<double>(double cutoff_Hz)> below;
  /// Standard deviation of the channel's noise below a cut-off.
  std::function<double(double cutoff_Hz)> noise;
  double cutoff_Hz = 0.0;  ///< Cut-off of the low-pass that it has passed.
  double step_s = 0.0;
  /// Within so many deviations of noise a sign grows in proportion to the channel.
  double unsure_deviations = 3.0;
};

/// Returns the sign of a filtered channel at each sample, as its mean over the sample's step, so
/// that a reversal counts when it happens. A low-pass moves a reversal where the channel bends; so
/// the widest band in which it exceeds its noise decides. Within `unsure_deviations` of the
/// filtered channel's noise the sign is in proportion to it.
std::vector<double> mean_signs(std::vector<double> filtered, const Bands& bands);

/// The same for an unfiltered channel with white noise of that deviation.
std::vector<double> mean_signs_of(const std::vector<double>& unfiltered, double deviation,
                                  double cutoff_Hz, double step_s);

}  // namespace torquewright::identification
