// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "simulation/excitation.hpp"
#include "simulation/joint/joint_state.hpp"

namespace torquewright::simulation {

/// What an excitation prescribes to a joint, or to all, at an instant: `share` (0 to 1) of the way
/// from a knot of its times to the next one.
DriveNow drive_at(const JointDrive& joint, std::size_t knot, double share);
std::vector<DriveNow> drives_at(const Excitation& excitation, std::size_t knot, double share);

/// A sequence of values at that instant, on the straight line between two knots. The last knot's
/// value holds beyond it.
double between(const std::vector<double>& values, std::size_t knot, double share);

}  // namespace torquewright::simulation
