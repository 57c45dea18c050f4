// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/draft/draft.hpp"

namespace torquewright::hopper {

/// Numbers greater than any that a robot's document holds are how files say that there is no limit:
/// such limits are left out, and a note counts them. Where one end alone of a range is so far away,
/// it becomes the farthest that a document holds.
void clear_far_limits(std::vector<DraftBody>& draft, std::vector<std::string>& notes);

}  // namespace torquewright::hopper
