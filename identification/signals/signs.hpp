// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

namespace torquewright::identification {

/// A channel in wider bands than that of its low-pass.
struct Bands {
  std::function<std::vector<double>(double cutoff_Hz)> below;  ///< Empty: of none is known.
  std::function<double(double cutoff_Hz)> noise;  ///< The deviation of its noise there.
  double cutoff_Hz = 0.0;                         ///< Of the low-pass that it has passed.
  double step_s = 0.0;
  double unsure_deviations = 3.0;  ///< Of its noise, within which a sign grows in proportion.
};

/// The sign of a filtered channel at each sample: its mean over the sample's step, so that a
/// reversal counts when it happens. A low-pass moves a reversal where the channel bends; so the
/// widest band in which it exceeds its noise decides. Within so many deviations of the filtered
/// channel's noise the sign is in proportion to it.
std::vector<double> mean_signs(std::vector<double> filtered, const Bands& bands);

/// Of a channel of white noise, which is given unfiltered.
std::vector<double> mean_signs_of(const std::vector<double>& unfiltered, double deviation,
                                  double cutoff_Hz, double step_s);

}  // namespace torquewright::identification
