// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/parts/gnuplot.hpp"
#include "src/report/robot/hopper_page.hpp"

namespace torquewright::report {

/// A script for gnuplot, over time: CAM, CAV and the composite inertia about the axis across the
/// sagittal plane (world's y, through the centre of mass), with each flight's begin and end. CAM is
/// the product of the other two where nothing turns about another axis. Empty where the dynamics
/// are not known.
std::string momentum_plot(PlotFormat format, const HopperPage& page);

}  // namespace torquewright::report
