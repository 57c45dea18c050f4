// SPDX-License-Identifier: Apache-2.0
#include "identification/rig/controller_spec.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/faults/json_text.hpp"
#include "io/text/name_pattern.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification {
namespace {

using nlohmann::json;

actuator::PositionLaw law_of(const json& stated) {
  actuator::PositionLaw law;
  law.stiffness_Nm_rad = stated["stiffness_Nm_rad"];
  law.damping_Nm_s_rad = stated.value("damping_Nm_s_rad", 0.0);
  law.torque_limit_Nm = stated.value("torque_limit_Nm", law.torque_limit_Nm);
  return law;
}

}  // namespace

std::vector<std::optional<actuator::PositionLaw>> controllers_of_json(
    const json& rig, const std::vector<std::string>& joints,
    const std::function<void(const std::string&, std::string)>& report) {
  if (!rig.contains("controller") && !rig.contains("controllers")) return {};
  std::vector<std::optional<actuator::PositionLaw>> laws(joints.size());
  if (rig.contains("controller")) laws.assign(joints.size(), law_of(rig["controller"]));
  const json by_joint = rig.value("controllers", json::object());
  for (const auto& [pattern, stated] : by_joint.items()) {
    bool fits = false;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (!io::fits_pattern(joints[i], pattern)) continue;
      laws[i] = law_of(stated);
      fits = true;
    }
    if (fits) continue;
    report(io::child_path("/controllers", pattern),
           fmt::format("fits no joint of the log; they are {}", io::listed(joints)));
  }
  return laws;
}

}  // namespace torquewright::identification
