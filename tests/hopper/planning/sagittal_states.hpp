// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hopper/planning/plane/sagittal_robot.hpp"
#include "tests/dynamics/random_numbers.hpp"

namespace torquewright::test {

/// specs/robot/NAME.json
hopper::Robot documented_robot(const std::string& name);

/// The hopper in its plane, but the rods of its ankle are 4 cm too short: pins that are 5 cm off
/// the ankle are out of their reach where they are lowest, at -1.5 rad, and within it at 0.
hopper::SagittalRobot hopper_with_short_rods();

/// The documented planar leg, on another body and with more to it: the shank ends in a heel and a
/// toe, the hip turns about -y, and the trunk carries a tail that turns in the plane and a head
/// that turns out of it. Drives of hip, knee and tail are direct.
hopper::Robot leg_with_tail();

/// A base that balances on a foot whose pin is in the contact points' line. Base: mass_kg at
/// height_m above the pin, inertia about it base_kg_m2 in all; foot: foot_kg at the pin. The
/// joint's drive is direct, its rotor stands in the joint.
struct Pendulum {
  double mass_kg = 5.0;
  double height_m = 0.4;
  double base_kg_m2 = 5.0 * 0.4 * 0.4 + 0.3;
  double foot_kg = 1.5;
  double foot_kg_m2 = 0.02;
  double rotor_kg_m2 = 0.05;
};
/// Contact points this far behind and before the pin; both 0: one, at the pin.
hopper::Robot pendulum(const Pendulum& of, double heel_m, double toe_m);

/// Of the tree on its planar base: joints that move within nine tenths of their ranges (of 1 rad
/// where they have none), everything else up to 2, accelerations up to 50.
hopper::TreeMotion random_motion(oracles::Dice& dice, const hopper::SagittalRobot& plane);

/// Rows of what moves.
Eigen::VectorXd moving_of(const hopper::SagittalRobot& plane, const Eigen::VectorXd& rows);

}  // namespace torquewright::test
