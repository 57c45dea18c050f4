// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/trials/randomisation.hpp"

namespace torquewright::hopper {

/// What the documents of a robot's drives leave open of their motors' strength, as
/// `torquewright actuator lint` takes it: the tolerance that a torque constant states (of a drive
/// known by its curve, its peak torque), or that its several sources make, else a catalogue's 10 %.
/// `assumed` says in words whose it is. Requires drives.
Randomisation tolerances_of_drives(const Robot& robot);

}  // namespace torquewright::hopper
