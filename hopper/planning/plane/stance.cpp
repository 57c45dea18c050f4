// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/plane/stance.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "io/faults/refusal.hpp"

namespace torquewright::hopper {
namespace {

std::vector<Stance> every_stance(const SagittalRobot& robot) {
  if (robot.sole.size() == 1) return {{"flat", {0}}, {"flight", {}}};
  const std::size_t toe = robot.sole.size() - 1;
  return {{"flat", {0, toe}}, {"heel", {0}}, {"toe", {toe}}, {"flight", {}}};
}

}  // namespace

bool Stance::adds_to(const Stance& other) const {
  return std::any_of(points.begin(), points.end(), [&other](std::size_t point) {
    return std::find(other.points.begin(), other.points.end(), point) == other.points.end();
  });
}

std::vector<Stance> stances_of(const SagittalRobot& robot, const std::vector<std::string>& names) {
  const std::vector<Stance> every = every_stance(robot);
  std::vector<std::string> known;
  for (const Stance& one : every) known.push_back(one.name);
  std::vector<Stance> out;
  for (const std::string& name : names) {
    const auto found = std::find_if(every.begin(), every.end(),
                                    [&name](const Stance& one) { return one.name == name; });
    if (found == every.end()) {
      io::refuse("--contacts", fmt::format("'{}' is no way in which this foot can stand; there are "
                                           "{}",
                                           name, fmt::join(known, ", ")));
    }
    if (!out.empty() && out.back().name == name) {
      io::refuse("--contacts", fmt::format("'{}' follows itself: one phase is enough", name));
    }
    out.push_back(*found);
  }
  if (out.empty() || out.front().name != "flat" || out.back().name != "flat") {
    io::refuse("--contacts", "a motion begins and ends standing: the first and the last is 'flat'");
  }
  return out;
}

}  // namespace torquewright::hopper
