// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/constraints/site.hpp"
#include "hopper/planning/plane/planned_motion.hpp"

namespace torquewright::hopper {

/// What the samples of a motion keep of planning margins, the least of all within phases; infinite
/// where none asks for it.
struct KeptMargins {
  double friction = 0.0;            ///< Share of the least coefficient, under kLeastLoad or more.
  double center_of_pressure = 0.0;  ///< Share of the foot, but where it is about to tip.
  double position_rad = 0.0;        ///< From the ends of joints' ranges, on the ground.
  double flight_position_rad = 0.0;
};

/// `program` names mesh and model; `forces_N` (3 contact points x samples) as `hopper check` finds
/// them.
KeptMargins kept_margins(const Site& program, const PlannedMotion& plan, const Motion& motion,
                         const Eigen::MatrixXd& forces_N);

}  // namespace torquewright::hopper
