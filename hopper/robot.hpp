// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actuator/actuator.hpp"
#include "dynamics/point.hpp"
#include "dynamics/tree.hpp"

namespace torquewright::hopper {

/// Where the robot may touch the ground.
struct ContactPoint {
  std::string name;
  dynamics::BodyPoint point;
  double friction_coefficient = 0;
  double restitution = 0;
};

enum class MechanismKind {
  kDirect,    ///< One actuator, one joint, speeds alike (also through a 1:1 four-bar).
  kParallel,  ///< Two actuators, two joints: actuator speeds are the Jacobian times joint speeds.
};

/// What stands between actuators and joints.
struct Mechanism {
  MechanismKind kind = MechanismKind::kDirect;
  std::vector<std::size_t> joints;  ///< By the body that the joint carries.
  std::vector<actuator::Actuator> actuators;
  std::vector<std::string> actuator_files;                 ///< As the document names them.
  Eigen::Matrix2d jacobian = Eigen::Matrix2d::Identity();  ///< Of a parallel one.
};

struct Robot {
  std::string name;
  dynamics::Tree tree;  ///< Joints carry their names.
  std::vector<ContactPoint> contacts;
  std::vector<Mechanism> mechanisms;
  std::vector<std::string> assumed;  ///< JSON pointers into its document.

  /// Index of the body that the joint carries; none if no joint has that name.
  std::optional<std::size_t> find_joint(const std::string& name) const;
};

}  // namespace torquewright::hopper
