// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/draft/draft.hpp"

namespace torquewright::hopper {

/// The contact points of a floating robot's shapes that collide: of those whose link is called a
/// foot, toe, ankle or sole where a body has such, else of bodies that carry no other and are not
/// called a head, a hand or a sensor; of their balls where there are any, else of other shapes.
/// Balls touch as they are, capsules and cylinders that lie by a ball at either end, boxes and
/// cylinders that stand by four points of the side that is the lower one where all joints are at
/// zero. Where the file states no friction it is assumed, and the robot says so. Notes say what was
/// taken, or that nothing was and what would help. Requires that no draft is welded.
void add_feet(const std::vector<DraftBody>& draft, Robot& robot, std::vector<std::string>& notes);

}  // namespace torquewright::hopper
