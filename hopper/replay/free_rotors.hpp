// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Rotors behind an elastic train (backlash, compliance) turn apart from their outputs: a replay's
/// drives move them, and what an engine moves is the robot without them.

/// Returns the inertia of rotor and gears at the actuator's output, in kg m^2: what its joint
/// states, where that holds the rotor of one joint, else as rotor_at_output_kg_m2().
double rotor_turned_kg_m2(const Robot& robot, const Drivetrain& drivetrain, std::size_t actuator);

/// Whether the actuator's rotor turns apart from its output: its effects let it, it has inertia,
/// and its inertia is not part of several joints' or of a changing ratio's.
bool is_rotor_free(const Robot& robot, const Drivetrain& drivetrain, std::size_t actuator);

/// Returns the robot as an engine moves it: without the inertia of free rotors, and without the
/// angular momentum that they carry for what holds them. Cranks stay.
Robot without_free_rotors(const Robot& robot);

}  // namespace torquewright::hopper
