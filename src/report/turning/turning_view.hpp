// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hopper/check/series.hpp"
#include "simulation/contact/ground_profile.hpp"
#include "src/report/turning/body_poses.hpp"
#include "src/report/turning/body_shapes.hpp"
#include "src/report/turning/force_scale.hpp"

namespace torquewright::report {

/// The columns of the ground's force on a contact point.
struct ForceColumns {
  std::string x;
  std::string y;
  std::string z;
};

/// A value that stands beside the pointer over a body.
struct ToldValue {
  std::string words;
  std::string column;
  std::string unit;
};

/// A robot and its motion in three dimensions.
struct TurningView {
  std::vector<BodyShape> shapes;             ///< By body.
  std::vector<std::vector<ToldValue>> told;  ///< By body.
  BodyPoses is;                              ///< By sample of the page's cursor.
  std::optional<BodyPoses> planned = {};     ///< What should have been, if that is shown.
  std::vector<ForceColumns> forces = {};     ///< By contact point; empty: none is known.
  double ground_m = 0.0;
  simulation::GroundProfile profile = {};  ///< Over that height.
  // What frames it.
  double size_m = 1.0;     ///< Of the robot itself.
  double longest_m = 0.0;  ///< Of the arrow of the greatest force.
  double radius_m = 1.0;   ///< Of the ball about the centre that holds all that is shown.
  Eigen::Vector3d center_m = Eigen::Vector3d::Zero();
  bool follows = false;  ///< The centre is above or below the centre of mass and goes along.
};

/// What it is made of.
struct ViewSource {
  const hopper::Robot& robot;
  const hopper::Series& series;
  const std::vector<Eigen::Index>& samples;  ///< Of the series: those that the cursor stands on.
  const std::vector<ForceColumns>& forces;
  const ForceScale& scale;
  double ground_m = 0.0;
  simulation::GroundProfile profile = {};  ///< Over that height.
};
/// Positions are those at the samples, a column each; `planned` may have none. The robot at all
/// samples is in the picture, with the arrows of its forces, the greatest among them. The pointer
/// tells of a body whatever columns the series has of its joint.
TurningView turning_view(const ViewSource& source, const Eigen::MatrixXd& positions,
                         const Eigen::MatrixXd& planned);

/// The spacing of lines on the ground: 1, 2 or 5 times a power of ten of a metre.
double grid_m(const TurningView& view);

}  // namespace torquewright::report
