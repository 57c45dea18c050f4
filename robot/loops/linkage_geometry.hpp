// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "robot/loops/loop_follower.hpp"
#include "robot/loops/rod_loop.hpp"
#include "robot/mechanisms/mechanism.hpp"

namespace torquewright::hopper {

/// The mechanism of a linkage, or why there is none, in a sentence.
using FoundMechanism = std::variant<std::shared_ptr<const Mechanism>, std::string>;

/// The four-bar that one loop with one held hinge is, if it is one: all hinges parallel, rods
/// between balls too.
FoundMechanism four_bar_of(const std::vector<DraftBody>& draft, const RodLoop& loop,
                           const LoopFollower& file_posture);

/// The parallel ankle that two loops are which hold the same two hinges from the same ground.
FoundMechanism parallel_ankle_of(const std::vector<DraftBody>& draft,
                                 const std::vector<RodLoop>& loops,
                                 const LoopFollower& file_posture);

}  // namespace torquewright::hopper
