// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/trials/randomisation.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// A range for bodies or joints, each of which draws its own number.
struct PartsRange {
  Range range;
  std::vector<std::string> names;
};

/// As it is, of one body and axis (0, 1, 2).
struct BodyShift {
  std::string body;
  std::size_t axis = 0;
  Range range_m;
};

/// A randomisation in the terms of simulators: by bodies and joints, where the document speaks of
/// drives. A drive that turns several joints is each one's by its own share, at the posture nearest
/// to zero.
struct DrawnParts {
  const Randomisation* stated = nullptr;
  std::vector<PartsRange> mass_factor;
  std::vector<PartsRange> inertia_factor;
  std::vector<BodyShift> center_of_mass_m;
  std::vector<PartsRange> gain_factor;      ///< By joint.
  std::vector<PartsRange> strength_factor;  ///< By joint, on what its drives' motors make,
  std::vector<PartsRange> drive_strength;   ///< and by drive.
  std::vector<PartsRange> dry_friction_Nm;  ///< By joint, beside what it has.
  std::vector<PartsRange> start_position_rad;
  std::vector<PartsRange> start_velocity_rad_s;
  std::vector<std::string> notes;     ///< What was made of it.
  std::vector<std::string> left_out;  ///< What no simulator's file here holds.
};

/// Requires that the randomisation fits the robot (require_fits()).
DrawnParts drawn_parts(const Randomisation& randomisation, const Robot& robot);

}  // namespace torquewright::hopper
