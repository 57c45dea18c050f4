// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/motor/actuator.hpp"

namespace torquewright::identification {

/// Computes the torque before the mesh, in Nm at the output, of effects that have a history (lag,
/// presliding) through a stretch of n samples; zeros where there are none. Rates are advanced
/// exactly over quarter steps, between which motion and input follow a cubic; before the first
/// sample they have settled. Friction passes the motion's low-pass (cut-off 0: none), because it is
/// no sum of what the motion is; a lag of a torque that has passed it needs none.
std::vector<double> torque_of_histories_Nm(const actuator::Actuator& actuator,
                                           const std::vector<actuator::Instant>& at,
                                           const std::vector<double>& motor_Nm, double step_s,
                                           double cutoff_Hz = 0.0);

}  // namespace torquewright::identification
