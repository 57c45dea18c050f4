// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/region/joint_region.hpp"
#include "src/options/mor_request.hpp"

namespace torquewright::cli {

/// A script for gnuplot: the region under the conditions; over it, dashed, the continuous rating
/// where the document has one, and what other voltages and temperatures make of it. Throws
/// io::SpecError.
std::string region_plot_of(const MorPlotOptions& options, const actuator::Actuator& actuator,
                           const actuator::OperatingConditions& conditions, actuator::Side side);

}  // namespace torquewright::cli
