// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "robot/mechanisms/parallel_ankle.hpp"
#include "tests/dynamics/random_numbers.hpp"

namespace torquewright::test {

/// With upright rods at zero: its Jacobian there is lever over crank, half distance over crank.
inline hopper::ParallelAnkleGeometry plain_ankle(double crank_m, double lever_m, double half_m) {
  hopper::ParallelAnkleGeometry ankle;
  ankle.first.axis = Eigen::Vector3d::UnitY();
  ankle.first.p_PB_m = {0, 0, -0.41};
  ankle.second.axis = Eigen::Vector3d::UnitX();
  for (const std::size_t i : {0u, 1u}) {
    const double side = i == 0 ? half_m : -half_m;
    const double height = i == 0 ? -0.24 : -0.12;
    hopper::AnkleRod& rod = ankle.rods[i];
    rod.actuator_center_m = {crank_m - lever_m, side, height};
    rod.crank_m = {-crank_m, 0, 0};
    rod.foot_attachment_m = {-lever_m, side, 0};
    rod.rod_length_m = height + 0.41;
  }
  ankle.rod_tilt_limit_rad = 0.6;
  ankle.transmission_limit_rad = 0.5;
  return ankle;
}

inline Eigen::Vector3d some_vector(oracles::Dice& dice, double size) {
  return {uniform(dice, -size, size), uniform(dice, -size, size), uniform(dice, -size, size)};
}

/// Everything askew: axes, places, joints whose axes do not meet, cranks that are no discs.
inline hopper::ParallelAnkleGeometry askew_ankle(oracles::Dice& dice) {
  hopper::ParallelAnkleGeometry ankle = plain_ankle(0.06, 0.05, 0.04);
  for (hopper::AnkleRod& rod : ankle.rods) {
    rod.actuator_axis = (rod.actuator_axis + some_vector(dice, 0.2)).normalized();
    rod.actuator_center_m += some_vector(dice, 0.01);
    rod.crank_m += some_vector(dice, 0.01);
    rod.foot_attachment_m += some_vector(dice, 0.01);
    rod.branch = dice.chance(50) ? 1 : -1;
  }
  for (dynamics::Joint* joint : {&ankle.first, &ankle.second}) {
    joint->axis = (joint->axis + some_vector(dice, 0.2)).normalized();
    joint->p_PB_m += some_vector(dice, 0.01);
    joint->R_PB = Eigen::AngleAxisd(uniform(dice, -0.2, 0.2), some_vector(dice, 1).normalized())
                      .toRotationMatrix();
  }
  return ankle;
}

inline hopper::SmallVector pair_of(double first, double second) {
  hopper::SmallVector pair(2);
  pair << first, second;
  return pair;
}

inline const hopper::MechanismMargin* margin_of(const std::vector<hopper::MechanismMargin>& margins,
                                                const std::string& name) {
  for (const hopper::MechanismMargin& margin : margins) {
    if (margin.name == name) return &margin;
  }
  return nullptr;
}

}  // namespace torquewright::test
