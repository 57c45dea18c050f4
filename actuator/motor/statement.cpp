// SPDX-License-Identifier: Apache-2.0
#include "actuator/motor/statement.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::actuator {
namespace {

/// The number of the model that a pointer leads to; nullptr for those of the data sheet.
double* model_value(Actuator& actuator, std::string_view pointer) {
  Motor& motor = actuator.motor;
  Drive& drive = actuator.drive;
  if (pointer == "/motor/torque_constant_Nm_A") return &motor.torque_constant_Nm_A;
  if (pointer == "/motor/back_emf_constant_V_s_rad") return &*motor.back_emf_constant_V_s_rad;
  if (pointer == "/motor/demagnetisation_current_A") return &motor.demagnetisation_current_A;
  if (pointer == "/drive/peak_current_A") return &drive.peak_current_A;
  if (pointer == "/drive/continuous_current_A") return &*drive.continuous_current_A;
  return nullptr;
}

/// At the motor per one at the joint.
double motor_share(const Transmission& gear, std::string_view pointer) {
  const double turns = std::abs(gear.ratio);
  const bool passes_teeth = pointer == "/motor/torque_constant_Nm_A";
  return 1.0 / (passes_teeth ? turns * gear.forward_efficiency : turns);
}

}  // namespace

const Statement* find_statement(const Actuator& actuator, std::string_view pointer) {
  const auto place =
      std::find_if(actuator.statements.begin(), actuator.statements.end(),
                   [pointer](const Statement& one) { return one.pointer == pointer; });
  return place == actuator.statements.end() ? nullptr : &*place;
}

bool is_at_joint(const Actuator& actuator, std::string_view pointer) {
  const Statement* statement = find_statement(actuator, pointer);
  if (statement != nullptr && statement->at_joint) return *statement->at_joint;
  return actuator.datasheet->joint_side;
}

void carry_to_motor(Actuator& actuator) {
  for (const Statement& statement : actuator.statements) {
    double* value = model_value(actuator, statement.pointer);
    if (value == nullptr) continue;
    if (statement.at_joint.value_or(false)) {
      *value = statement.printed * motor_share(actuator.transmission, statement.pointer);
    }
    if (statement.ampere) {
      *value = statement.printed * phase_amperes_per_ampere(*statement.ampere) /
               phase_amperes_per_ampere(actuator.motor.torque_constant_convention);
    }
  }
}

}  // namespace torquewright::actuator
