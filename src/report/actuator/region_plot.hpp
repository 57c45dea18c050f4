// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "actuator/drive_check/report.hpp"
#include "actuator/mor/mor_table.hpp"
#include "src/report/parts/gnuplot.hpp"
#include "src/report/parts/plotted_region.hpp"

namespace torquewright::report {

/// A script for gnuplot: regions in the plane of speed and torque, the first with thick lines and
/// shaded, each bound in the colour of its limiter; all others dashed.
std::string region_plot(PlotFormat format, const std::string& title,
                        const std::vector<PlottedRegion>& regions);

/// One panel of a motion's picture.
struct PlottedMotion {
  std::string title;
  actuator::MorTable region;
  std::vector<actuator::TracePoint> trace;
};

/// A script for gnuplot: for each actuator its region and in it the motion, coloured by time, what
/// lies outside marked.
std::string motion_plot(PlotFormat format, const std::string& title,
                        const std::vector<PlottedMotion>& motions);

}  // namespace torquewright::report
