// SPDX-License-Identifier: Apache-2.0
#include "identification/correction.hpp"

namespace torquewright::identification {

Correction corrected(const Equation& equation, std::size_t k, double change, double error) {
  Correction correction = equation.corrections[k];
  correction.value = correction.stated + change;
  correction.standard_error = error;
  if (equation.target_is_motor_side && correction.pointer == "/motor/torque_constant_Nm_A") {
    // change/stated = 1 - stated/value.
    correction.value = correction.stated / (1.0 - change / correction.stated);
    const double share = correction.value / correction.stated;
    correction.standard_error = error * share * share;
  }
  return correction;
}

}  // namespace torquewright::identification
