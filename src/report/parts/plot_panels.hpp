// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "hopper/motion/motion.hpp"
#include "src/report/parts/gnuplot.hpp"

namespace torquewright::report {

/// One curve of a panel over time.
struct PlotCurve {
  std::string label;
  std::function<double(Eigen::Index sample)> at;
};

struct PlotPanel {
  std::string axis;  ///< With the unit.
  std::vector<PlotCurve> curves;
};

/// An instant that all panels show, dashed; its word stands in the topmost.
struct PlotMark {
  double time_s = 0.0;
  std::string word;  ///< May be empty.
};

/// A script for gnuplot: panels one below the other over the time of a motion. Requires a panel.
std::string panels_plot(PlotFormat format, const hopper::Motion& motion,
                        const std::vector<PlotPanel>& panels, const std::vector<PlotMark>& marks);

}  // namespace torquewright::report
