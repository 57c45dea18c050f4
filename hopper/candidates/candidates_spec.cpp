// SPDX-License-Identifier: Apache-2.0
#include "hopper/candidates/candidates_spec.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace torquewright::hopper {
namespace {

using nlohmann::ordered_json;

ordered_json number(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return *value;
}

}  // namespace

ordered_json candidates_json(const Robot& robot, const std::vector<CandidateResult>& results) {
  ordered_json list = ordered_json::array();
  for (const CandidateResult& result : results) {
    list.push_back(
        {{"drives", robot.drivetrains[result.drivetrain].actuator_names},
         {"candidate", result.name},
         {"ratio", result.ratio},
         {"verdict", actuator::name_of(result.verdict)},
         {"margin_share", number(result.margin_share)},
         {"speed_margin_rad_s", number(result.speed_margin_rad_s)},
         {"mass_kg", number(result.mass_kg)},
         {"energy_J", number(result.energy_J)},
         {"copper_loss_J", number(result.copper_loss_J)},
         {"peak_torque_Nm", number(result.peak_torque_Nm)},
         {"rotor_inertia_kg_m2", result.rotor_inertia_kg_m2},
         {"torques", result.torques == CandidateTorques::kDynamics ? "dynamics"
                                                                   : "file_with_rotors_exchanged"},
         {"on_pareto_front", result.is_on_front},
         {"why", result.why}});
  }
  return list;
}

}  // namespace torquewright::hopper
