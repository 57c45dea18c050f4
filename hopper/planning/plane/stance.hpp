// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/planning/plane/sagittal_robot.hpp"

namespace torquewright::hopper {

/// Points of the sole that are on the ground. Of several, the outermost bear the load, and the
/// force along the ground is one: the sole is rigid and its points are level.
struct Stance {
  std::string name;
  /// Indices of points of the sole: none, one, or the rearmost and the foremost.
  std::vector<std::size_t> points;

  bool is_flight() const { return points.empty(); }
  PlanFrame frame() const { return is_flight() ? PlanFrame::kMass : PlanFrame::kSole; }
  bool is_flat() const { return points.size() == 2; }
  /// What it holds of the foot: x and z by the rearmost point, the pitch by both.
  bool holds_place() const { return !points.empty() && points.front() == 0; }
  bool holds_pitch() const { return is_flat(); }
  /// Number of forces: one along the ground, if any point touches, then one upwards for each point.
  std::size_t force_count() const { return points.empty() ? 0 : 1 + points.size(); }
  /// Whether a point touches in this stance that does not in the other.
  bool adds_to(const Stance& other) const;
};

/// Stances by their names: "flat", "heel", "toe", "flight"; "flat" of a foot of one point is that
/// point. io::SpecError, naming the stance and those that there are, where one is unknown, two
/// alike follow each other, or the first or the last is no full stance.
std::vector<Stance> stances_of(const SagittalRobot& robot, const std::vector<std::string>& names);

}  // namespace torquewright::hopper
