// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "robot/model/workspace.hpp"
#include "src/report/parts/gnuplot.hpp"

namespace torquewright::report {

/// A script for gnuplot: the postures of two joints, in degrees, by what keeps their mechanism from
/// them, and the rectangle of the joints' ranges.
std::string workspace_plot(PlotFormat format, const std::string& title,
                           const hopper::Workspace& workspace);

/// The same in shares.
std::string workspace_text(const hopper::Workspace& workspace);

}  // namespace torquewright::report
