// SPDX-License-Identifier: Apache-2.0
#include "actuator/winding/winding_estimate_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace torquewright::actuator {
namespace {

nlohmann::ordered_json interval_json(const WindingInterval& interval) {
  return {{"low", interval.low},
          {"high", std::isfinite(interval.high) ? nlohmann::ordered_json(interval.high)
                                                : nlohmann::ordered_json()}};
}

}  // namespace

nlohmann::ordered_json winding_json(const WindingEstimate& estimate) {
  return {{"torque_constant_Nm_A", interval_json(estimate.torque_constant_Nm_A)},
          {"resistance_ohm", interval_json(estimate.resistance_ohm)},
          {"voltage_V", interval_json(estimate.voltage_V)},
          {"current_A", interval_json(estimate.current_A)},
          {"rests_on", estimate.rests_on},
          {"contradiction", estimate.contradiction.empty()
                                ? nlohmann::ordered_json()
                                : nlohmann::ordered_json(estimate.contradiction)}};
}

}  // namespace torquewright::actuator
