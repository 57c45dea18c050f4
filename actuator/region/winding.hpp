// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/motor/actuator.hpp"

namespace torquewright::actuator {

/// The winding as a quasi-static line, in the actuator's own convention: V = R i + Ke w_motor, at
/// the temperature at which the document states it.
struct Winding {
  double resistance_ohm = 0.0;
  double back_emf_V_s_rad = 0.0;
};
Winding winding_of(const Actuator& actuator);

/// Resistance of that winding at the instant's temperature, in ohm.
double resistance_ohm(const Actuator& actuator, const Winding& winding, const Instant& at);

}  // namespace torquewright::actuator
