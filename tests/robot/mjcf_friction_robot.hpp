// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "actuator/effects/library.hpp"
#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/model/robot.hpp"
#include "robot/model/robot_json.hpp"
#include "robot/model/robot_spec.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::test {

inline void give_friction(actuator::Actuator& drive, double coulomb_Nm, double viscous_Nm_s_rad) {
  actuator::Effect dry = actuator::neutral(*actuator::find_effect("coulomb_friction"));
  actuator::Effect viscous = actuator::neutral(*actuator::find_effect("viscous_friction"));
  dry.values = {coulomb_Nm};
  viscous.values = {viscous_Nm_s_rad};
  drive.effects = {dry, viscous};
}

/// The hopper of specs/robot, every drive with that friction and nothing else beside its motor.
inline hopper::Robot hopper_with_friction(double coulomb_Nm, double viscous_Nm_s_rad) {
  const std::filesystem::path folder(TORQUEWRIGHT_SOURCE_DIR "/specs/robot");
  hopper::Robot robot = hopper::read_robot(folder / "hopper.json").robot;
  for (hopper::Drivetrain& drivetrain : robot.drivetrains) {
    for (actuator::Actuator& drive : drivetrain.actuators) {
      give_friction(drive, coulomb_Nm, viscous_Nm_s_rad);
    }
  }
  return robot;
}

struct DryAndViscous {
  double coulomb_Nm = 0.0;
  double viscous_Nm_s_rad = 0.0;
};
struct DampingAndFriction {
  double damping_Nm_s_rad = 0.0;
  double dry_friction_Nm = 0.0;
};

/// A link of 0.1 kg m^2 on a hinge in the world, turned about a vertical axis by a drive that the
/// mini cheetah has at its hip.
inline hopper::Robot driven_hinge(DryAndViscous drive, DampingAndFriction own) {
  const ScratchFolder folder;
  nlohmann::ordered_json document = hopper::robot_json(
      hopper::read_mjcf(folder.write("hinge.xml", R"(<mujoco><worldbody><body name="link">
        <joint name="hinge" axis="0 0 1"/><inertial pos="0 0 0" mass="1" diaginertia="0.1 0.1 0.1"/>
        </body></worldbody></mujoco>)"))
          .robot);
  document["mechanisms"] = {
      {{"type", "direct"},
       {"joints", {"hinge"}},
       {"actuators", {TORQUEWRIGHT_SOURCE_DIR "/specs/actuator/mini_cheetah_hip.json"}}}};
  const auto file = folder.write("hinge.json", document.dump());
  hopper::Robot robot = hopper::read_robot(file).robot;
  give_friction(robot.drivetrains[0].actuators[0], drive.coulomb_Nm, drive.viscous_Nm_s_rad);
  robot.tree.bodies[1].joint.passive = {own.damping_Nm_s_rad, own.dry_friction_Nm,
                                        own.dry_friction_Nm, 0.0, 0.0};
  return robot;
}

}  // namespace torquewright::test
