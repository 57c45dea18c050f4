// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "hopper/verdict/every_deed.hpp"
#include "hopper/verdict/turn.hpp"

namespace torquewright::hopper {
namespace {

/// In degrees to a tenth; what rounding left of nothing has no sign.
double shown_deg(double angle_rad) {
  return std::round(10.0 * angle_rad * 180.0 / std::numbers::pi) / 10.0 + 0.0;
}

}  // namespace

std::vector<Deed> rotation(const Attempt& attempt) {
  if (attempt.robot.tree.base == dynamics::BaseKind::kFixed) return {};
  const dynamics::Tree& tree = attempt.robot.tree;
  const Eigen::Vector3d planned_rad = planned_turn_rad(
      tree, attempt.reference, attempt.record.control_period_s, attempt.reference.ends_s());
  const Eigen::Vector3d axis = axis_of_turn(planned_rad);
  Deed deed;
  deed.name = "rotation";
  deed.unit = "rad";
  deed.planned = axis.dot(planned_rad);
  deed.done = axis.dot(turned_rad(tree, attempt.record, attempt.record.end_s));
  deed.off = std::abs(deed.done - deed.planned);
  deed.tolerance = attempt.tolerances.turn_rad;
  deed.is_done = deed.off <= deed.tolerance;
  deed.sentence = fmt::format("the base turns by {:.1f} of {:.1f} degrees", shown_deg(deed.done),
                              shown_deg(deed.planned));
  return {deed};
}

}  // namespace torquewright::hopper
