// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hopper/files/element.hpp"
#include "hopper/robot/robot.hpp"

namespace torquewright::hopper {

/// A ball of a body that may meet the ground.
struct DraftBall {
  std::string name;
  Eigen::Vector3d center_m;  ///< In the body's frame.
  double radius_m = 0;
  std::optional<double> friction_coefficient;
};

/// A body as a file has it: perhaps welded to its parent, perhaps without mass.
struct DraftBody {
  dynamics::Body body;  ///< Parents come first.
  bool is_welded = false;
  const Element* source = nullptr;  ///< Of the inertia; null where the file states no such body.
  double rounding_kg_m2 = 0;        ///< By so much its moments may be off by how they are written.
  std::vector<DraftBall> balls = {};
};

/// A robot read from another format, and what was left behind, in sentences.
struct Imported {
  Robot robot;
  std::vector<std::string> notes;
};

/// Where a drafted body's frame stands in the kept body that it is part of.
struct DraftPlace {
  std::size_t kept = 0;
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p_m = Eigen::Vector3d::Zero();
};
std::vector<DraftPlace> places_of(const std::vector<DraftBody>& draft);

/// Welded bodies become part of their parents.
std::vector<dynamics::Body> without_welds(const std::vector<DraftBody>& draft);

}  // namespace torquewright::hopper
