// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// Standard deviations of white noise on the raw channels of a joint, by Quantity, each in its
/// channel's unit. For a measured channel it is at least the resolution over sqrt(12): the step of
/// a quantised one, the last digit that the log writes, single precision. A command (and a winding
/// voltage that holds set values) has only that of its last digit. 0: not logged, or fewer than 16
/// samples.
using NoiseLevels = std::array<double, kQuantityCount>;
NoiseLevels noise_levels(const Log& log, std::size_t joint);

/// The same of steady states, none of which has a neighbour in time: what depends on speed and
/// drive (torque sensor, voltages) has its scatter about neighbouring states (scatter.hpp), which
/// holds the noise of these two as well; they themselves have the last digit that the log writes.
NoiseLevels noise_of_states(const Log& log, std::size_t joint);

}  // namespace torquewright::identification
