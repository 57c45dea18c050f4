// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "actuator/region/joint_region.hpp"

namespace torquewright::actuator {

/// What one sample of a motion asks of motor, drive and supply.
struct Demand {
  double current_A = 0.0;         ///< Amplitude of the current, in the document's convention.
  double phase_current_A = 0.0;   ///< Amplitude of the current of one phase.
  double motor_torque_Nm = 0.0;   ///< Torque before the gears.
  double bus_power_W = 0.0;       ///< Power from the bus; negative: returned.
  double voltage_margin_V = 0.0;  ///< Still available at the bus; negative: missing; minus
                                  ///< infinity: the supply cannot deliver the power.
};

/// Returns the motor's torque before the gears that a torque on the load needs at a joint speed:
/// the inverse of the region's order of losses, mesh, then drag (cogging at no torque: its mean).
/// At rest friction helps to hold, as it does in the region (docs/derivations/check.md eq. (3)).
double rotor_torque_Nm(const Actuator& actuator, double temperature_K, double speed_rad_s,
                       double torque_Nm);

/// Returns the demand of a torque on the load at a joint speed, by rotor_torque_Nm(). Empty where
/// no current yields the torque (saturation); docs/derivations/check.md eq. (3), (4).
std::optional<Demand> demand_at(const Actuator& actuator, const PhaseModel& model,
                                double temperature_K, double speed_rad_s, double torque_Nm);

}  // namespace torquewright::actuator
