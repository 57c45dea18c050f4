// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace torquewright::test {

constexpr Eigen::Index kWalkVelocities = 7;  ///< Of the planar base x, z, pitch; then four joints.
constexpr Eigen::Index kWalkJoints = 4;      ///< Left hip, right hip, left knee, right knee.

/// The folder of Rabbit's published walking, or nothing where it is absent.
std::filesystem::path rabbit_folder();

/// One of its tables, a row per knot, time first.
Eigen::MatrixXd rabbit_table(const std::filesystem::path& folder, const std::string& name);

struct WalkInstant {
  Eigen::VectorXd position, velocity, acceleration;  ///< (7 x 1) each
};

/// A stretch of the walking on one foot.
struct WalkMode {
  std::vector<double> times_s;
  Eigen::MatrixXd positions, velocities, accelerations;  ///< (7 x knots)
  std::size_t stance = 0;  ///< Index of the point that stands, in specs/robot/rabbit.json.

  double from_s() const { return times_s.front(); }
  double until_s() const { return times_s.back(); }
  /// Positions and velocities cubic between knots with the stored rates as slopes, as their authors
  /// collocated them; the acceleration is the slope of velocity. Past the ends: those of the ends.
  WalkInstant at(double time_s) const;
};

/// Modes 0, 1, 2 stand on the left, right, left foot.
using Walk = std::array<WalkMode, 3>;

Walk read_walk(const std::filesystem::path& folder);

}  // namespace torquewright::test
