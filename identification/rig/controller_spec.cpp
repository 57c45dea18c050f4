// SPDX-License-Identifier: Apache-2.0
#include "identification/rig/controller_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/faults/json_text.hpp"
#include "io/text/name_pattern.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification {
namespace {

using nlohmann::json;

class ControllerReader {
 public:
  ControllerReader(const json& rig,
                   const std::function<void(const std::string&, std::string)>& report)
      : report_(report), uncertain_(rig.value("uncertain", std::vector<std::string>())) {}

  JointController read(const std::string& pointer, const json& stated) const {
    JointController one;
    const bool is_servo = stated["type"] == "position_servo";
    one.states_stiffness = stated.contains("stiffness_Nm_rad");
    if (!one.states_stiffness && !is_servo) {
      report_(pointer + "/stiffness_Nm_rad",
              "missing; a gain that is not known is to be found of \"type\": \"position_servo\"");
    }
    one.law.stiffness_Nm_rad = stated.value("stiffness_Nm_rad", 0.0);
    one.law.damping_Nm_s_rad = stated.value("damping_Nm_s_rad", 0.0);
    one.law.torque_limit_Nm = stated.value("torque_limit_Nm", one.law.torque_limit_Nm);
    one.delay_s = stated.value("delay_s", 0.0);
    one.finds_stiffness = is_servo || is_uncertain(pointer + "/stiffness_Nm_rad");
    one.finds_damping = is_uncertain(pointer + "/damping_Nm_s_rad");
    const bool states_delay = stated.contains("delay_s");
    one.finds_delay = (is_servo && !states_delay) || is_uncertain(pointer + "/delay_s");
    return one;
  }

 private:
  bool is_uncertain(const std::string& pointer) const {
    return std::find(uncertain_.begin(), uncertain_.end(), pointer) != uncertain_.end();
  }

  const std::function<void(const std::string&, std::string)>& report_;
  std::vector<std::string> uncertain_;
};

}  // namespace

std::vector<std::optional<JointController>> controllers_of_json(
    const json& rig, const std::vector<std::string>& joints,
    const std::function<void(const std::string&, std::string)>& report) {
  if (!rig.contains("controller") && !rig.contains("controllers")) return {};
  const ControllerReader reader(rig, report);
  std::vector<std::optional<JointController>> controllers(joints.size());
  if (rig.contains("controller")) {
    controllers.assign(joints.size(), reader.read("/controller", rig["controller"]));
  }
  const json by_joint = rig.value("controllers", json::object());
  for (const auto& [pattern, stated] : by_joint.items()) {
    const std::string pointer = io::child_path("/controllers", pattern);
    const JointController own = reader.read(pointer, stated);
    bool fits = false;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (!io::fits_pattern(joints[i], pattern)) continue;
      controllers[i] = own;
      fits = true;
    }
    if (fits) continue;
    report(pointer, fmt::format("fits no joint of the log; they are {}", io::listed(joints)));
  }
  return controllers;
}

}  // namespace torquewright::identification
