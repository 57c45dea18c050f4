// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "dynamics/tree.hpp"
#include "robot/draft/draft.hpp"
#include "robot/mechanisms/mechanism.hpp"

namespace torquewright::hopper {

/// Where a mechanism does not reach all of a joint's range, but its cranks' own ranges end before:
/// narrows the joint's range to what they allow, the others at their positions nearest to zero.
/// `joints` are those that it moves, `cranks` the limits of what the actuators turn, one each.
/// Sentences about what was narrowed.
std::vector<std::string> narrow_to_cranks(const Mechanism& mechanism,
                                          const std::vector<dynamics::Joint*>& joints,
                                          const std::vector<dynamics::JointLimits>& cranks);

/// The same of drafts, by index: joints that are held, in the drafts to be narrowed, and joints
/// that are turned.
void narrow_held(const Mechanism& mechanism, const std::vector<std::size_t>& held,
                 const std::vector<std::size_t>& turned, const std::vector<DraftBody>& draft,
                 std::vector<DraftBody>& narrowed, std::vector<std::string>& notes);

}  // namespace torquewright::hopper
