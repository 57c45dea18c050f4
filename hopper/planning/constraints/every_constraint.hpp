// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/constraints/constraint.hpp"

// One line for each constraint, in the order of rows at one site; its file defines the constant of
// that name.
#define TORQUEWRIGHT_EVERY_CONSTRAINT(constraint)                                                 \
  constraint(positions_go_on) constraint(velocities_go_on) constraint(range) constraint(speed)    \
      constraint(equations_of_motion) constraint(feet_stay) constraint(drives) constraint(ground) \
          constraint(pressure_between_knots) constraint(above_the_ground) constraint(duration)    \
              constraint(feet_on_the_ground) constraint(goes_on) constraint(impact)               \
                  constraint(feet_stop) constraint(impulse) constraint(base_upright)              \
                      constraint(landing_load) constraint(mass_over_the_sole)                     \
                          constraint(capture_point) constraint(pace) constraint(alike)

namespace torquewright::hopper::constraints {

#define TORQUEWRIGHT_DECLARE(name) extern const Constraint name;
TORQUEWRIGHT_EVERY_CONSTRAINT(TORQUEWRIGHT_DECLARE)
#undef TORQUEWRIGHT_DECLARE

}  // namespace torquewright::hopper::constraints
