// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/exporters/exporter.hpp"
#include "robot/urdf/urdf_writer.hpp"

namespace torquewright::hopper {

/// All drives of a robot as one file of a simulator that limits torque joint by joint: drives that
/// are alike share an entry. Joints that a linkage couples, or turns at a ratio that changes, have
/// what each has alone at the posture nearest to zero; notes say what that leaves out. `friction`
/// at the joint: of every drive whose gear does not lock itself. `origin` lines head the file.
/// Requires exporter.write_all; throws io::SpecError where a drive has no region or the robot has
/// no drives.
Exported actuators_of(const Robot& robot, const actuator::Exporter& exporter,
                      const std::vector<std::string>& origin,
                      actuator::FrictionPlace friction = actuator::FrictionPlace::kLimits);

}  // namespace torquewright::hopper
