// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <numbers>
#include <optional>
#include <string>

#include "robot/xml/xml.hpp"

namespace torquewright::hopper {

/// Whether a body's mass is that of its shapes.
enum class FromShapes { kAlways, kWhereNotStated, kNever };

/// What <compiler> says of how numbers are meant. Later elements overrule earlier ones.
struct MjcfCompiler {
  double rad_per_angle = std::numbers::pi / 180;
  std::string euler_axes = "xyz";
  /// Whether places, directions and orientations inside bodies are the world's, in the file's pose.
  bool is_global = false;
  bool are_limits_automatic = true;
  FromShapes inertia = FromShapes::kWhereNotStated;
  std::array<double, 2> shape_groups{0, 5};
  double least_mass_kg = 0;
  double least_moment_kg_m2 = 0;
  bool balances_inertia = false;
  std::optional<double> total_mass_kg;
};

MjcfCompiler read_compiler(const Element& mujoco, Faults& faults);

/// Orientation by quat, axisangle, euler, xyaxes or zaxis; none of them: the identity.
Eigen::Matrix3d rotation_of(const Element& element, const MjcfCompiler& compiler, Faults& faults);

/// Returns the rotation that takes z to this direction in the plane of both.
Eigen::Matrix3d rotation_of_z(const Eigen::Vector3d& direction);

}  // namespace torquewright::hopper
