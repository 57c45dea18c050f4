// SPDX-License-Identifier: Apache-2.0
// A robot as a tree of bodies and hinges, whatever file it came from.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace torquewright::oracles::robot_bench {

/// Its frame sits at the joint that carries it.
struct Body {
  std::string name;
  double mass_kg = 0;
  Eigen::Vector3d center_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia_kg_m2 = Eigen::Matrix3d::Zero();  ///< About the centre, in its axes.

  /// Adds what has this mass, centre and inertia about it, in this body's frame.
  void add(double mass_kg, const Eigen::Vector3d& center_m, const Eigen::Matrix3d& inertia_kg_m2);
};

struct Joint {
  std::string name, parent, child;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< Of the child's frame in the parent's.
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();
  double low_rad = -1, high_rad = 1;
  double armature_kg_m2 = 0, damping_Nm_s_rad = 0, friction_Nm = 0;

  double middle_rad() const { return 0.5 * (low_rad + high_rad); }
};

/// Joints stand after the one that carries them.
struct Robot {
  std::string name, base;
  bool floats = false;
  std::vector<Body> bodies;
  std::vector<Joint> joints;
  /// Joints that do not move while the log is taken, at zero, and that it does not hold.
  std::vector<std::string> held;
  /// Joints of one hardware.
  std::vector<std::vector<std::string>> alike;

  Body& body(const std::string& of);
  const Body& body(const std::string& of) const;
  Joint& joint(const std::string& of);
  const Joint& joint(const std::string& of) const;
  bool is_held(const std::string& joint) const;
  std::vector<std::string> moved() const;
  /// The joint that carries a body; null of the base.
  const Joint* carrier(const std::string& body) const;
};

}  // namespace torquewright::oracles::robot_bench
