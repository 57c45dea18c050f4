// SPDX-License-Identifier: Apache-2.0
#include "hopper/files/feet.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace torquewright::hopper {
namespace {

constexpr double kRubber = 0.8;  // on dry concrete: 0.6 to 0.85

std::string free_name(const std::string& name, const Robot& robot) {
  const auto is_taken = [&](const std::string& wanted) {
    return std::any_of(robot.contacts.begin(), robot.contacts.end(),
                       [&](const ContactPoint& other) { return other.name == wanted; });
  };
  std::string found = name;
  for (int count = 2; is_taken(found); ++count) found = fmt::format("{}_{}", name, count);
  return found;
}

}  // namespace

void add_feet(const std::vector<DraftBody>& draft, Robot& robot) {
  if (robot.tree.base == dynamics::BaseKind::kFixed) return;
  std::vector<bool> carries(draft.size(), false);
  for (std::size_t i = 1; i < draft.size(); ++i) carries[draft[i].body.parent] = true;
  for (std::size_t i = 0; i < draft.size(); ++i) {
    if (carries[i]) continue;
    for (const DraftBall& ball : draft[i].balls) {
      if (!ball.friction_coefficient) {
        robot.assumed.push_back(
            fmt::format("/contacts/{}/friction_coefficient", robot.contacts.size()));
      }
      robot.contacts.push_back({free_name(ball.name, robot),
                                {i, ball.center_m},
                                ball.friction_coefficient.value_or(kRubber),
                                0.0,
                                ball.radius_m});
    }
  }
}

}  // namespace torquewright::hopper
