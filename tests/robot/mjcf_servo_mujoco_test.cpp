// SPDX-License-Identifier: Apache-2.0
// Drives as servos in the file of a whole robot, run by MuJoCo. Oracle: kp = I w^2, kv = 2 z I w by
// hand, w = 2 pi 10 Hz and z = 2, and the law kp (target - q) - kv q' within the motor's torque.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/faults/spec_error.hpp"
#include "robot/mjcf/mjcf_writer.hpp"
#include "tests/dynamics/mujoco_engine.hpp"
#include "tests/robot/mjcf_friction_robot.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kW_rad_s = 2.0 * std::numbers::pi * 10.0;
constexpr double kZ = 2.0;

struct ServoState {
  double target_rad, position_rad, speed_rad_s;
};
constexpr ServoState kStates[] = {
    {0.02, 0.0, 0.0}, {0.0, -0.01, 0.4}, {2.0, -1.0, 0.0}, {-2.0, 1.0, -3.0}, {0.1, 0.1, 9.0}};

TEST(ServoMjcf, IsTheLawOfItsGainsWithinTheMotorsTorque) {
  test::MujocoEngine mujoco(
      mjcf_of(test::driven_hinge({0.4, 0.02}, {0.01, 0.1}), {.actuators = true, .servos = true})
          .text);
  const mjModel& model = mujoco.model();
  mjData& data = mujoco.data();
  const double inertia_kg_m2 = model.dof_armature[0];
  ASSERT_GT(inertia_kg_m2, 0.0);
  const double most_Nm = model.actuator_forcerange[1];
  const double voltage_file_Nm =
      test::MujocoEngine(
          mjcf_of(test::driven_hinge({0.4, 0.02}, {0.01, 0.1}), {.actuators = true}).text)
          .model()
          .actuator_forcerange[1];
  EXPECT_EQ(most_Nm, voltage_file_Nm);
  for (const ServoState& state : kStates) {
    data.ctrl[0] = state.target_rad;
    data.qpos[0] = state.position_rad;
    data.qvel[0] = state.speed_rad_s;
    mj_forward(&mujoco.model(), &data);
    const double asked_Nm =
        inertia_kg_m2 * kW_rad_s * kW_rad_s * (state.target_rad - state.position_rad) -
        2.0 * kZ * inertia_kg_m2 * kW_rad_s * state.speed_rad_s;
    EXPECT_NEAR(data.qfrc_actuator[0], std::clamp(asked_Nm, -most_Nm, most_Nm), 1e-9 * most_Nm);
  }
}

// By hand: at rest under dry friction c alone it stays within c / kp of its target.
TEST(ServoMjcf, SettlesWithinItsFriction) {
  test::MujocoEngine mujoco(
      mjcf_of(test::driven_hinge({0.4, 0.02}, {0.01, 0.1}), {.actuators = true, .servos = true})
          .text);
  mjData& data = mujoco.data();
  data.ctrl[0] = 0.5;
  for (int i = 0; i < 5000; ++i) mj_step(&mujoco.model(), &data);
  const double kp_Nm_rad = mujoco.model().dof_armature[0] * kW_rad_s * kW_rad_s;
  EXPECT_LE(std::abs(data.qpos[0] - 0.5), 1.01 * 0.5 / kp_Nm_rad);
}

// Drives that share joints are told their own angles, which are their tendons' lengths; friction
// stands where it does without servos.
TEST(ServoMjcf, TellsCoupledDrivesTheirOwnAngles) {
  const Robot robot = test::hopper_with_friction(0.3, 0.06);
  test::MujocoEngine mujoco(mjcf_of(robot, {.actuators = true, .servos = true}).text);
  const mjModel& model = mujoco.model();
  mjData& data = mujoco.data();
  ASSERT_EQ(model.ntendon, 2);
  for (int i = 0; i < model.nv; ++i) data.qvel[i] = 0.1 * (i + 1);
  for (int i = 7; i < model.nq; ++i) data.qpos[i] += 0.01 * i;
  mj_forward(&mujoco.model(), &data);
  const Drivetrain& ankle = robot.drivetrains[1];
  for (std::size_t k = 0; k < 2; ++k) {
    const int drive = mj_name2id(&model, mjOBJ_ACTUATOR, ankle.actuator_names[k].c_str());
    const int tendon = model.actuator_trnid[2 * drive];
    const double inertia_kg_m2 = turned_at_output_kg_m2(ankle, k);
    const double asked_Nm = -inertia_kg_m2 * kW_rad_s * kW_rad_s * data.ten_length[tendon] -
                            2.0 * kZ * inertia_kg_m2 * kW_rad_s * data.ten_velocity[tendon];
    const double most_Nm = model.actuator_forcerange[2 * drive + 1];
    EXPECT_NEAR(data.actuator_force[drive], std::clamp(asked_Nm, -most_Nm, most_Nm), 1e-9);
    EXPECT_NEAR(model.tendon_frictionloss[tendon], 0.3, 1e-15);
  }
}

TEST(ServoMjcf, RefusesADriveWithoutInertia) {
  Robot robot = test::driven_hinge({}, {});
  robot.drivetrains[0].actuators[0].motor.rotor_inertia_kg_m2 = 0.0;
  robot.tree.bodies[1].joint.reflected_inertia = 0.0;
  EXPECT_THROW(mjcf_of(robot, {.actuators = true, .servos = true}), io::SpecError);
}

}  // namespace
}  // namespace torquewright::hopper
