// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actuator/drive_check/report.hpp"
#include "actuator/mor/mor_table.hpp"
#include "src/report/parts/gnuplot.hpp"
#include "src/report/parts/plotted_region.hpp"

namespace torquewright::report {

/// A point that is needed, and how far it is from the first region's nearer bound.
struct PlottedNeed {
  double speed_rad_s = 0.0;
  double torque_Nm = 0.0;
  double margin_Nm = 0.0;  ///< Negative: so much is missing. Infinite: no torque is there.
  double bound_Nm = 0.0;   ///< The nearer bound, where the margin is finite.
};

/// A script for gnuplot: regions in the plane of speed and torque, the first with thick lines and
/// shaded, each bound in the colour of its limiter; all others dashed. The need, where there is
/// one, stands as a point with its distance to the bound.
std::string region_plot(PlotFormat format, const std::string& title,
                        const std::vector<PlottedRegion>& regions,
                        const std::optional<PlottedNeed>& need = std::nullopt);

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
