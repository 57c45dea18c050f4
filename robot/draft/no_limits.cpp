// SPDX-License-Identifier: Apache-2.0
#include "robot/draft/no_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/xml/vocabulary.hpp"
#include "robot/xml/xml_text.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// The greatest that specs/schema/robot.json holds.
struct Greatest {
  double effort;  ///< Nm, N.
  double speed;   ///< rad/s, m/s.
};
constexpr Greatest kTurning{1e6, 1e5};
constexpr Greatest kSliding{1e7, 1e4};

/// True where something was changed.
bool clear_bound(double greatest, double& bound) {
  if (std::isinf(bound) || !(bound > greatest)) return false;
  bound = kNoBound;
  return true;
}

bool clear_range(dynamics::JointLimits& limits) {
  const bool has_range = limits.position_min > -kNoBound || limits.position_max < kNoBound;
  const bool is_low = limits.position_min <= -kNoRange;
  const bool is_high = limits.position_max >= kNoRange;
  if (!has_range || (!is_low && !is_high)) return false;
  limits.position_min = is_high && is_low ? -kNoBound : std::max(limits.position_min, -kNoRange);
  limits.position_max = is_high && is_low ? kNoBound : std::min(limits.position_max, kNoRange);
  return true;
}

}  // namespace

void clear_far_limits(std::vector<DraftBody>& draft, std::vector<std::string>& notes) {
  std::size_t count = 0;
  std::vector<std::string> joints;
  for (DraftBody& next : draft) {
    dynamics::Joint& joint = next.body.joint;
    const bool turns = joint.kind == dynamics::JointKind::kRevolute;
    const Greatest& greatest = turns ? kTurning : kSliding;
    const std::size_t before = count;
    count += clear_range(joint.limits) ? 1 : 0;
    count += clear_bound(greatest.effort, joint.limits.effort_max) ? 1 : 0;
    count += clear_bound(greatest.speed, joint.limits.speed_max) ? 1 : 0;
    if (count > before) joints.push_back(joint.name);
  }
  if (count == 0) return;
  notes.push_back(
      fmt::format("{} limit{} greater than any that a document holds {} left out: they say that "
                  "there is none: {}",
                  count, count == 1 ? "" : "s", count == 1 ? "is" : "are", listed(joints)));
}

}  // namespace torquewright::hopper
