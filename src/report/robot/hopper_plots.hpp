// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "src/report/parts/gnuplot.hpp"
#include "src/report/robot/hopper_page.hpp"

namespace torquewright::report {

/// A script for gnuplot: each drive's region and in it the motion. Requires kept traces.
std::string drives_plot(PlotFormat format, const hopper::Robot& robot,
                        const actuator::OperatingConditions& conditions, const std::string& title,
                        const hopper::HopperReport& report);

/// A script for gnuplot, over time: the drives' torques, the ground's force, what passes each
/// transmission, CAM and CAV. Empty where the dynamics are not known.
std::string loads_plot(PlotFormat format, const HopperPage& page);

}  // namespace torquewright::report
