// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "actuator/motor/actuator.hpp"
#include "io/documents/document.hpp"

namespace torquewright::actuator {

/// What a sheet prints in the place of what the model needs: a speed per volt for the torque
/// constant, torques at the joint for currents. These functions require what the schema of
/// `actuator` demands; what is missing, or stands there twice, goes to `faults`.

/// The torque constant with its convention, stated or from the motor's velocity constant.
void read_torque_constant(const io::Document& document, Actuator& actuator,
                          std::vector<io::Fault>& faults);

/// Of each current of the drive: that it stands there, or a torque in its place, not both.
void check_torques_for_currents(const io::Document& document, std::vector<io::Fault>& faults);

/// Currents that give the stated torques at the joint. Requires constants that were carried to the
/// motor. Effects (friction, saturation) are not counted.
void take_torques_for_currents(const io::Document& document, Actuator& actuator,
                               std::vector<io::Fault>& faults);

/// A sentence with the formula for each value that was found so; `actuator` is that of the
/// document.
std::vector<std::string> derived_values(const io::Document& document, const Actuator& actuator);

}  // namespace torquewright::actuator
