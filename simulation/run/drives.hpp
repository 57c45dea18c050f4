// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "simulation/excitation.hpp"
#include "simulation/joint/joint_state.hpp"

namespace torquewright::simulation {

/// Returns what an excitation prescribes to a joint, or to all, at `share` (0 to 1) of the way from
/// a knot of its times to the next one.
DriveNow drive_at(const JointDrive& joint, std::size_t knot, double share);
std::vector<DriveNow> drives_at(const Excitation& excitation, std::size_t knot, double share);

/// Interpolates a sequence of values there, linearly between two knots. Beyond the last knot its
/// value holds.
double between(const std::vector<double>& values, std::size_t knot, double share);

}  // namespace torquewright::simulation
