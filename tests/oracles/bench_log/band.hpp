// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/oracles/bench_log/bench.hpp"

namespace torquewright::oracles {

inline constexpr double kBand_Hz = 8.0;

/// The signal below the band's edge: a Butterworth low-pass of second order, forwards and
/// backwards, so that nothing is delayed (half the amplitude at the edge).
std::vector<double> in_band(const std::vector<double>& signal, double sample_rate_Hz,
                            double edge_Hz = kBand_Hz);

/// Root of the mean square of the residuals of an equation in the band, over all runs.
double residual_rms(const std::vector<CleanRun>& runs, const std::string& equation,
                    double sample_rate_Hz);

/// Per equation that the channels allow: rms that their noise has in the residual, in the band, in
/// closed form. White noise of sigma has sigma sqrt(B / f_N) below B; its n-th derivative
/// sigma (2 pi B)^n sqrt(B / f_N / (2n + 1)). Speed and acceleration come from whichever channel
/// gives the lesser noise.
std::map<std::string, double> noise_floors(const Bench& bench);

}  // namespace torquewright::oracles
