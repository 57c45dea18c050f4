// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/motion/motion.hpp"

namespace torquewright::hopper {

/// Returns words for what derived accelerations come from, such as "positions in steps of 0.000383
/// (rad or m)", or "noisy velocities" where no steps are found.
std::string source_words(const Motion& motion);

/// Returns words for what in the log would make derived accelerations better known, where steps or
/// noise decided their window.
std::string better_log(const Motion& motion);

}  // namespace torquewright::hopper
