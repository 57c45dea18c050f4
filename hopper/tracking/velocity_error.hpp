// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/tracking/impact_handling.hpp"
#include "hopper/tracking/reference_clock.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {

/// Returns the points that a planned impact, the one that begins a mode, gives impulses.
TouchingPoints landing_points(const Robot& robot, const Reference& reference, std::size_t mode,
                              bool whole_foot);

/// Removes from the velocities' error (n x 1, wanted less actual) what the options say of the
/// nearest planned impact. The body is set to the observed state, or the aligned one.
void handle_velocity_error(const ImpactOptions& options, const Reference& reference,
                           const ClockReading& reading, WholeBody& body, Eigen::VectorXd& error);

}  // namespace torquewright::hopper
