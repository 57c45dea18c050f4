// SPDX-License-Identifier: Apache-2.0
#include "identification/answer/joints_json.hpp"

#include <nlohmann/json.hpp>

#include "identification/findings/joint_verdicts.hpp"

namespace torquewright::identification {
namespace {

using nlohmann::ordered_json;

/// Whether an effect is of what the drives move, and not of the joint in whose equation it showed.
bool is_of_rig(const ordered_json& entry) {
  return entry.value("family", "") == name_of(EffectFamily::kRig);
}

bool names_one_of(const ordered_json& group, const ordered_json& effects) {
  for (const ordered_json& effect : effects) {
    if (effect.value("joint", "") != group.value("joint", "")) continue;
    for (const ordered_json& name : group["effects"]) {
      if (name == effect["effect"]) return true;
    }
  }
  return false;
}

template <typename Which>
ordered_json those(const ordered_json& list, Which&& which) {
  ordered_json chosen = ordered_json::array();
  for (const ordered_json& each : list) {
    if (which(each)) chosen.push_back(each);
  }
  return chosen;
}

ordered_json joint_json(const JointVerdict& joint, const ordered_json& report) {
  const auto is_own = [&](const ordered_json& entry) {
    return entry.value("joint", "") == joint.joint;
  };
  return {{"joint", joint.joint},
          {"verdict", name_of(joint.verdict)},
          {"effects_added",
           those(report["effects_added"],
                 [&](const ordered_json& entry) { return is_own(entry) && !is_of_rig(entry); })},
          {"confounded", those(report["confounded"], is_own)},
          {"unexplained", those(report["unexplained"], is_own)}};
}

}  // namespace

void add_joints(const Identification& found, ordered_json& report) {
  const std::vector<JointVerdict> joints = joint_verdicts(found.equations);
  if (joints.empty()) return;
  report["joints"] = ordered_json::array();
  for (const JointVerdict& each : joints) report["joints"].push_back(joint_json(each, report));
  const ordered_json of_load = those(report["effects_added"], is_of_rig);
  report["load"] = {{"effects_added", of_load},
                    {"confounded", those(report["confounded"], [&](const ordered_json& group) {
                       return names_one_of(group, of_load);
                     })}};
}

}  // namespace torquewright::identification
