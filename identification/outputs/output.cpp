// SPDX-License-Identifier: Apache-2.0
#include "identification/outputs/output.hpp"

#include <algorithm>
#include <vector>

#include "actuator/region/torque_at.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification {
namespace {

constexpr double kLittleCurrent = 1e-6;  ///< Of the peak: far below any saturation.

}  // namespace

double torque_per_ampere_Nm_A(const actuator::Actuator& actuator) {
  actuator::Instant at;
  at.current_A = kLittleCurrent * actuator.drive.peak_current_A;
  at.winding_temperature_K = at.reference_temperature_K = actuator.motor.winding_temperature_K;
  return actuator::motor_torque_Nm(actuator, at) / at.current_A;
}

double stated(const actuator::Actuator& actuator, std::string_view effect,
              std::string_view parameter) {
  for (const actuator::Effect& each : actuator.effects) {
    if (each.kind->name != effect) continue;
    for (std::size_t i = 0; i < each.kind->parameters.size(); ++i) {
      if (each.kind->parameters[i].name == parameter) return each.values[i];
    }
  }
  return 0.0;
}

std::string others(const actuator::Actuator& actuator, std::span<const std::string_view> known) {
  std::vector<std::string> names;
  for (const actuator::Effect& each : actuator.effects) {
    if (std::find(known.begin(), known.end(), each.kind->name) == known.end()) {
      names.emplace_back(each.kind->name);
    }
  }
  return io::listed(names);
}

}  // namespace torquewright::identification
