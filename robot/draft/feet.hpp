// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/draft/draft.hpp"

namespace torquewright::hopper {

/// The contact points that a floating robot's file states: balls at the bodies that carry no other,
/// which are feet, and hands. Where the file states no friction it is assumed, and the robot says
/// so. Requires that no draft is welded.
void add_feet(const std::vector<DraftBody>& draft, Robot& robot);

}  // namespace torquewright::hopper
