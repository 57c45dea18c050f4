// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robot/draft/draft.hpp"
#include "robot/mjcf/mjcf_context.hpp"

namespace torquewright::hopper {

/// Adds the file's keyframes to the robot's postures, by their names: where its joints stand, over
/// an upright base. `mujoco`: the file's root; `imported`: with its tree and joint_places. Notes
/// list those that were read, and those that were not and why: of another length than the file's
/// joints ask for, or outside a joint's range.
void read_keyframes(const Element& mujoco, const MjcfDefaults& defaults, Imported& imported);

}  // namespace torquewright::hopper
