// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace torquewright::oracles::sampled {

inline constexpr double kBand_hz = 8.0;

/// One course per run.
using Courses = std::vector<std::vector<double>>;

/// Low-passed at kBand_hz forwards and backwards (Butterworth, second order): no phase.
std::vector<double> in_band(const std::vector<double>& values, double period_s);
/// Of each course, in the band; a quarter of a second at either end of a run does not count.
double band_rms(const Courses& courses, double period_s);
/// Central differences.
std::vector<double> rate_of(const std::vector<double>& values, double period_s);

}  // namespace torquewright::oracles::sampled
