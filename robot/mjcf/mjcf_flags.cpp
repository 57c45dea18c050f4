// SPDX-License-Identifier: Apache-2.0
#include "robot/mjcf/mjcf_flags.hpp"

#include <algorithm>

namespace torquewright::hopper {

void MjcfFlags::add(const Element& flag) {
  for (const auto& [name, value] : flag.attributes) {
    if (value == "disable") disabled_.insert(name);
  }
}

bool MjcfFlags::disables(std::initializer_list<const char*> flags) const {
  return std::any_of(flags.begin(), flags.end(),
                     [this](const char* flag) { return disabled_.contains(flag); });
}

std::vector<std::string> MjcfFlags::drop_forces(std::vector<DraftBody>& draft) const {
  std::vector<std::string> changed;
  for (DraftBody& one : draft) {
    dynamics::PassiveForces& passive = one.body.joint.passive;
    const dynamics::PassiveForces stated = passive;
    if (disables({"passive", "damper"})) passive.damping = 0;
    if (disables({"passive", "spring"})) passive.stiffness = passive.rest_position = 0;
    if (disables({"frictionloss", "constraint"})) passive.dry_friction = 0;
    const bool is_changed = passive.damping != stated.damping ||
                            passive.stiffness != stated.stiffness ||
                            passive.dry_friction != stated.dry_friction;
    if (is_changed) changed.push_back(one.body.joint.name);
  }
  return changed;
}

}  // namespace torquewright::hopper
