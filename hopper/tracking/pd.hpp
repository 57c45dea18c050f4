// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/tracking/controller.hpp"
#include "hopper/tracking/drive_loops.hpp"
#include "hopper/tracking/reference_clock.hpp"

namespace torquewright::hopper {

/// The reference's torques and, for errors of the drives' positions and speeds, more of them.
/// Robot and reference must outlive it. Throws as pd_gains().
std::unique_ptr<Controller> pd_controller(const Robot& robot, const Reference& reference,
                                          const PdOptions& options, const ClockOptions& clock,
                                          const ImpactOptions& impact);

}  // namespace torquewright::hopper
