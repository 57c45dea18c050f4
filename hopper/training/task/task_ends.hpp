// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/tracking/reference.hpp"
#include "hopper/training/task/ready_task.hpp"

namespace torquewright::hopper {

/// A motion of two samples: the start of a task, and its end, where the robot stands as it began
/// and has turned as the task says. What lies between says nothing.
Motion motion_of_ends(const ReadyTask& ready);

/// The same as a reference, all contact points touching.
Reference reference_of_ends(const ReadyTask& ready);

}  // namespace torquewright::hopper
