// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/log/log.hpp"

namespace torquewright::identification {

/// Adds to each joint whose controller's law the rig states the torque that it asked for, from the
/// commanded and the measured position, as commanded_torque_Nm. The speed is that of the measured
/// position between the samples beside. Throws io::SpecError where a law is stated
/// and the log lacks a channel for it, or holds that torque already.
void add_commanded_torques(const Rig& rig, Log& log);

}  // namespace torquewright::identification
