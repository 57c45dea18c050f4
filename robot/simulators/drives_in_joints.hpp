// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/exporters/exporter.hpp"
#include "robot/urdf/urdf_writer.hpp"

namespace torquewright::hopper {

/// The robot with what its drives are to each joint in the joints themselves, for formats whose
/// joints state the greatest effort and speed: the box of the exporter's law, friction beside what
/// the joint has itself where the format has some, and rotors. A limit that is the joint's own
/// stays where it is narrower. `drives` gets what that leaves out.
Robot with_drives_in_joints(const Robot& robot, const actuator::Exporter& exporter,
                            actuator::FrictionPlace friction, DrivesInJoints& drives);

}  // namespace torquewright::hopper
