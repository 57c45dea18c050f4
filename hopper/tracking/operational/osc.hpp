// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "hopper/tracking/controller_kind.hpp"
#include "hopper/tracking/operational/tasks.hpp"

namespace torquewright::hopper {

/// Operational-space control along a motion: at each look the torques, within what the drives can
/// give, under which the tasks move most nearly as wanted (TorqueProgram). Where a program has no
/// answer the motion's own torques are asked for, held to the drives' bounds. Robot and reference
/// must outlive it.
std::unique_ptr<Controller> operational_controller(const Robot& robot, const Reference& reference,
                                                   std::shared_ptr<const OperationalTasks> tasks,
                                                   std::shared_ptr<const DriveRanges> ranges,
                                                   const TrackingOptions& options);

}  // namespace torquewright::hopper
