// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "dynamics/tree.hpp"

namespace torquewright::hopper {

/// A passive force of a joint, as a robot document names it.
struct PassiveKey {
  const char* of_revolute;
  const char* of_prismatic;
  double dynamics::PassiveForces::*value;
};

/// All of them, in the order in which documents state them.
inline constexpr std::array kPassiveKeys{
    PassiveKey{"damping_Nm_s_rad", "damping_N_s_m", &dynamics::PassiveForces::damping},
    PassiveKey{"dry_friction_Nm", "dry_friction_N", &dynamics::PassiveForces::dry_friction},
    PassiveKey{"static_friction_Nm", "static_friction_N",
               &dynamics::PassiveForces::static_friction},
    PassiveKey{"stiffness_Nm_rad", "stiffness_N_m", &dynamics::PassiveForces::stiffness},
    PassiveKey{"spring_rest_rad", "spring_rest_m", &dynamics::PassiveForces::rest_position},
};

}  // namespace torquewright::hopper
