// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference, "compiler", and its overview, "Frame orientations".
#include "robot/mjcf/mjcf_compiler.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cctype>

namespace torquewright::hopper {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kNoDirection = 1e-6;

bool is_euler_sequence(const std::string& text) {
  return text.size() == 3 && text.find_first_not_of("xyzXYZ") == std::string::npos;
}

void read_words(const Element& element, MjcfCompiler& compiler, Faults& faults) {
  if (find_attribute(element, "angle") != nullptr) {
    const bool is_radian = faults.one_of(element, "angle", {"degree", "radian"}) == "radian";
    compiler.rad_per_angle = is_radian ? 1 : std::numbers::pi / 180;
  }
  if (find_attribute(element, "eulerseq") != nullptr) {
    compiler.euler_axes = attribute(element, "eulerseq");
    if (!is_euler_sequence(compiler.euler_axes)) {
      faults.report(element, fmt::format("eulerseq=\"{}\" must be three of x, y, z, X, Y, Z",
                                         compiler.euler_axes));
      compiler.euler_axes = "xyz";
    }
  }
  if (find_attribute(element, "autolimits") != nullptr) {
    compiler.are_limits_automatic =
        faults.one_of(element, "autolimits", {"true", "false"}) == "true";
  }
  if (find_attribute(element, "balanceinertia") != nullptr) {
    compiler.balances_inertia =
        faults.one_of(element, "balanceinertia", {"true", "false"}) == "true";
  }
  if (find_attribute(element, "inertiafromgeom") != nullptr) {
    const std::string when = faults.one_of(element, "inertiafromgeom", {"auto", "true", "false"});
    compiler.inertia = when == "true"    ? FromShapes::kAlways
                       : when == "false" ? FromShapes::kNever
                                         : FromShapes::kWhereNotStated;
  }
  if (find_attribute(element, "coordinate") != nullptr) {
    compiler.is_global = faults.one_of(element, "coordinate", {"local", "global"}) == "global";
  }
}

void read_numbers(const Element& element, MjcfCompiler& compiler, Faults& faults) {
  compiler.least_mass_kg = faults.number(element, "boundmass", compiler.least_mass_kg);
  compiler.least_moment_kg_m2 = faults.number(element, "boundinertia", compiler.least_moment_kg_m2);
  const double total_kg = faults.number(element, "settotalmass", -1);
  if (total_kg > 0) compiler.total_mass_kg = total_kg;
  if (const auto groups = faults.numbers(element, "inertiagrouprange", 2)) {
    compiler.shape_groups = {groups->front(), groups->back()};
  }
}

Matrix3d turn(double angle_rad, const Vector3d& axis) {
  return Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix();
}

/// Small letters turn with the frame, capital ones about the axes that stay.
Matrix3d rotation_of_euler(const std::vector<double>& angles, const MjcfCompiler& compiler) {
  Matrix3d R = Matrix3d::Identity();
  for (std::size_t i = 0; i < 3; ++i) {
    const char letter = compiler.euler_axes[i];
    const bool moves = std::islower(static_cast<unsigned char>(letter)) != 0;
    const int axis = std::tolower(static_cast<unsigned char>(letter)) - 'x';
    const Matrix3d next = turn(compiler.rad_per_angle * angles[i], Vector3d::Unit(axis));
    R = moves ? Matrix3d(R * next) : Matrix3d(next * R);
  }
  return R;
}

/// x, and y made square to it.
std::optional<Matrix3d> rotation_of_axes(const std::vector<double>& numbers) {
  const Vector3d x(numbers[0], numbers[1], numbers[2]);
  const Vector3d y(numbers[3], numbers[4], numbers[5]);
  if (x.norm() < kNoDirection || x.cross(y).norm() < kNoDirection * x.norm()) return std::nullopt;
  Matrix3d R;
  R.col(0) = x.normalized();
  R.col(2) = x.cross(y).normalized();
  R.col(1) = R.col(2).cross(R.col(0));
  return R;
}

std::optional<Matrix3d> rotation_of_quaternion(const std::vector<double>& q) {
  const Eigen::Quaterniond quaternion(q[0], q[1], q[2], q[3]);
  if (quaternion.norm() < kNoDirection) return std::nullopt;
  return quaternion.normalized().toRotationMatrix();
}

std::optional<Matrix3d> rotation_of_axis_angle(const std::vector<double>& a,
                                               const MjcfCompiler& compiler) {
  const Vector3d axis(a[0], a[1], a[2]);
  if (axis.norm() < kNoDirection) return std::nullopt;
  return turn(compiler.rad_per_angle * a[3], axis.normalized());
}

}  // namespace

Matrix3d rotation_of_z(const Vector3d& direction) {
  return Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), direction).toRotationMatrix();
}

MjcfCompiler read_compiler(const Element& mujoco, Faults& faults) {
  MjcfCompiler compiler;
  for (const Element* element : children(mujoco, "compiler")) {
    read_words(*element, compiler, faults);
    read_numbers(*element, compiler, faults);
  }
  return compiler;
}

Matrix3d rotation_of(const Element& element, const MjcfCompiler& compiler, Faults& faults) {
  std::optional<Matrix3d> found;
  int stated = 0;
  const auto take = [&](const char* name, std::size_t count, auto&& rotation) {
    const auto numbers = faults.numbers(element, name, count);
    if (!numbers) return;
    ++stated;
    found = rotation(*numbers);
    if (!found) faults.report(element, fmt::format("{} has no direction", name));
  };
  using Numbers = std::vector<double>;
  take("quat", 4, rotation_of_quaternion);
  take("axisangle", 4, [&](const Numbers& a) { return rotation_of_axis_angle(a, compiler); });
  take("xyaxes", 6, rotation_of_axes);
  take("euler", 3, [&](const Numbers& angles) -> std::optional<Matrix3d> {
    return rotation_of_euler(angles, compiler);
  });
  take("zaxis", 3, [](const Numbers& z) -> std::optional<Matrix3d> {
    const Vector3d direction(z[0], z[1], z[2]);
    if (direction.norm() < kNoDirection) return std::nullopt;
    return rotation_of_z(direction);
  });
  if (stated > 1) faults.report(element, "states its orientation in several ways");
  return found.value_or(Matrix3d::Identity());
}

}  // namespace torquewright::hopper
