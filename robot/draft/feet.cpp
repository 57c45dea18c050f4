// SPDX-License-Identifier: Apache-2.0
#include "robot/draft/feet.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

namespace torquewright::hopper {
namespace {

constexpr double kRubber = 0.8;  // on dry concrete: 0.6 to 0.85

/// Names that are given once each: a second "toe" is "toe_2".
class FreeNames {
 public:
  explicit FreeNames(const std::vector<ContactPoint>& taken) {
    for (const ContactPoint& contact : taken) taken_.insert(contact.name);
  }

  std::string next(const std::string& name) {
    int& count = counts_[name];  // none below it is free any more
    std::string found = count == 0 ? name : fmt::format("{}_{}", name, count + 1);
    while (!taken_.insert(found).second) found = fmt::format("{}_{}", name, ++count + 1);
    return found;
  }

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> counts_;
};

}  // namespace

void add_feet(const std::vector<DraftBody>& draft, Robot& robot) {
  if (robot.tree.base == dynamics::BaseKind::kFixed) return;
  std::vector<bool> carries(draft.size(), false);
  for (std::size_t i = 1; i < draft.size(); ++i) carries[draft[i].body.parent] = true;
  FreeNames names(robot.contacts);
  for (std::size_t i = 0; i < draft.size(); ++i) {
    if (carries[i]) continue;
    for (const DraftBall& ball : draft[i].balls) {
      if (!ball.friction_coefficient) {
        robot.assumed.push_back(
            fmt::format("/contacts/{}/friction_coefficient", robot.contacts.size()));
      }
      robot.contacts.push_back({names.next(ball.name),
                                {i, ball.center_m},
                                ball.friction_coefficient.value_or(kRubber),
                                0.0,
                                ball.radius_m});
    }
  }
}

}  // namespace torquewright::hopper
