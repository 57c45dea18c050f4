// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/check/series.hpp"
#include "src/report/robot/stick_figures.hpp"
#include "src/report/turning/turning_view.hpp"

namespace torquewright::report {

/// A drive as the script speaks of it: the columns that it reads.
struct SpokenDrive {
  std::string name;
  std::string torque;
  std::string speed;
  std::string outside;  ///< Not zero where the torque lies outside the drive's region.
};

/// What the page's script moves its marks by.
struct CursorSource {
  const hopper::Series& series;
  const std::vector<Eigen::Index>& samples;  ///< That the cursor may stand on.
  const std::vector<ShownViolation>& violations;
  const MovingFigure* figure = nullptr;  ///< Null where there is none.
  double begin_s = 0.0;
  std::vector<std::string> headers = {};  ///< What of the series; those that are not there: none.
  std::vector<SpokenDrive> drives = {};
  std::vector<ForceColumns> forces = {};  ///< By contact point; empty: none is known.
  std::string view = {};                  ///< JSON of the turning view (view_json).
  double longest_m = 0.0;                 ///< In that: the arrow of the greatest force.
};

/// Adds the view, and the columns that its pointer tells of. Requires the view's figure.
void add_view(const hopper::Robot& robot, const TurningView& view, CursorSource& source);

/// The source as JSON that may stand inside an HTML element: names hold no character that could end
/// it.
std::string cursor_json(const CursorSource& source);

}  // namespace torquewright::report
