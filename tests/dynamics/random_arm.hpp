// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dynamics/serial_arm.hpp"
#include "tests/dynamics/random_numbers.hpp"

namespace torquewright::test {

/// Centres beyond the tip and behind the joint included.
inline dynamics::SerialArm random_arm(oracles::Dice& dice, Eigen::Index joints) {
  std::vector<dynamics::SerialLink> links;
  for (Eigen::Index i = 0; i < joints; ++i) {
    links.push_back({.mass_kg = uniform(dice, 0.1, 5),
                     .length_m = uniform(dice, 0.1, 1),
                     .center_of_mass_m = uniform(dice, -0.2, 0.8),
                     .inertia_kg_m2 = uniform(dice, 0.01, 0.5)});
  }
  return dynamics::SerialArm(links);
}

}  // namespace torquewright::test
