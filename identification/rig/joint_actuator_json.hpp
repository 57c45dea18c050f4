// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/motor/actuator_spec.hpp"
#include "identification/rig/rig.hpp"

namespace torquewright::identification {

/// The actuator that the joint of a rig's robot speaks of where nobody names another: its
/// document's reflected inertia, damping, friction and spring, as if a motor of 1 N m/A turned the
/// joint directly, so that an ampere is a newton metre. A speed or an effort limit that it lacks is
/// assumed, as is the winding, of which no log of positions and torques can tell; "assumed" says
/// so. Its document stands in no file: `path` says of which joint it was made. Throws io::SpecError
/// for a joint that holds more at rest than it takes moving: at which speed that changes no robot
/// states. Requires a load that is a robot; `joint` is an index into Rig::joints.
actuator::ReadActuator actuator_of_joint(const Rig& rig, std::size_t joint);

}  // namespace torquewright::identification
