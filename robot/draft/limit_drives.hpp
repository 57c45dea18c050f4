// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robot/draft/draft.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Actuator documents made of what an imported robot states of its joints.
struct LimitDrives {
  struct Drive {
    std::string file;      ///< Its name, without a folder; alike joints share one.
    std::string document;  ///< Of kind actuator, as text.
  };
  std::vector<Drive> drives;
  struct Assignment {
    std::string joint;
    std::size_t drive = 0;  ///< Which of the above turns it.
  };
  std::vector<Assignment> assignments;
  /// A drive within a closed loop, of which nobody named the actuator.
  struct LoopAssignment {
    std::size_t mechanism = 0;  ///< Of the robot's.
    std::size_t actuator = 0;   ///< Of the mechanism's.
    std::size_t drive = 0;
  };
  std::vector<LoopAssignment> in_loops;
  std::vector<std::string> unlimited;  ///< Drives of loops that state no limit of torque.
  std::vector<std::string> notes;      ///< Joints that none was made for, and why.
};

/// A drive for each joint that states a limit of torque, or of force, and has no drive yet: that
/// torque at every speed, up to the limit of speed if it states one, friction and gears apart, as
/// simulators take both limits. The same for drives of mechanisms whose actuator_files is "", of
/// what `loop_drives` says of them. Of a slide, what documents call a torque is a force.
LimitDrives limit_drives(const Robot& robot,
                         const std::map<std::string, StatedDrive>& loop_drives = {});

/// The same drives in the robot itself (Drivetrain::is_of_limits): no document of its joints'
/// motors need be there for a motion to be held against what they state.
void drive_by_limits(Robot& robot);

/// A robot's document, as text, with the drives as direct mechanisms; their files are in that
/// folder as the document sees it.
std::string with_limit_drives(const LimitDrives& made, const std::string& folder,
                              const std::string& robot);

}  // namespace torquewright::hopper
