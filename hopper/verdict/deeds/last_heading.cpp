// SPDX-License-Identifier: Apache-2.0
#include "hopper/verdict/every_deed.hpp"
#include "hopper/verdict/heading_deed.hpp"

namespace torquewright::hopper {

std::vector<Deed> last_heading(const Attempt& attempt) {
  if (attempt.robot.tree.base != dynamics::BaseKind::kSpatial) return {};
  ReferenceInstant goal;
  attempt.reference.at(attempt.reference.ends_s(), goal);
  return {heading_deed(attempt.robot.tree, goal.position, attempt.record.rows.back().position,
                       attempt.tolerances.heading_rad)};
}

}  // namespace torquewright::hopper
