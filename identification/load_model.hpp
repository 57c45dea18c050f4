// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/motor/actuator.hpp"
#include "identification/rig.hpp"
#include "identification/signals.hpp"

namespace torquewright::identification {

/// The winding as a quasi-static line, in the actuator's own convention: V = R i + Ke w_motor.
struct Winding {
  double resistance_ohm = 0.0;
  double back_emf_V_s_rad = 0.0;
};
Winding winding_of(const actuator::Actuator& actuator);

/// Copper's, or what a stated effect says; and the resistance that follows at an instant.
double resistance_coefficient_1_K(const actuator::Actuator& actuator);
double resistance_ohm(const actuator::Actuator& actuator, const Winding& winding,
                      const actuator::Instant& at);

/// Torque that the load of the rig takes, by its stated values: inertia and gravity. Not for a
/// dynamometer, whose load is whatever it is.
std::vector<double> model_load_Nm(const Rig& rig, std::size_t joint, const Signals& signals);

/// Derivative of that torque by the load's own mass, at an instant (not for arms).
double load_mass_column(const Rig& rig, const actuator::Instant& at);

}  // namespace torquewright::identification
