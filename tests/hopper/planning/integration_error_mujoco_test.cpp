// SPDX-License-Identifier: Apache-2.0
// Oracle: MuJoCo's own fourth-order integrator at small steps, on the same tree.
#include <gtest/gtest.h>

#include "hopper/planning/programme/integration_error.hpp"
#include "tests/dynamics/mujoco_engine.hpp"
#include "tests/dynamics/tree_mjcf.hpp"
#include "tests/hopper/planning/sagittal_states.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// A leg that is thrown and moves under torques that are parabolas in time: what MuJoCo makes of it
/// is a plan without error, but for both integrators' own.
TEST(IntegrationErrorBesideMujoco, OfAFlightIsNone) {
  const SagittalRobot plane = sagittal(test::documented_robot("planar_leg"));
  test::MujocoEngine mujoco(test::mjcf_of(plane.robot.tree));
  mujoco.model().opt.integrator = mjINT_RK4;
  constexpr double kStep_s = 1e-4;
  constexpr int kSteps = 50;  // From an instant to the next: intervals of 10 ms.
  mujoco.model().opt.timestep = kStep_s;
  VectorXd q(5), v(5);
  q << 0.1, 0.6, 0.2, -0.7, 1.5;
  v << 0.5, 2.0, 1.0, 3.0, -4.0;
  mujoco.set(q, v);
  const auto torque_Nm = [](double t) {
    return VectorXd(Eigen::Vector2d(0.5 - 8.0 * t + 60.0 * t * t, -1.0 + 20.0 * t - 150.0 * t * t));
  };
  PlannedPhase phase{"flight", {false}, {}};
  for (int i = 0; i <= 20; ++i) {
    const Eigen::Map<const VectorXd> position(mujoco.data().qpos, 5),
        velocity(mujoco.data().qvel, 5);
    const TreeMotion mass =
        frame_motion(plane, PlanFrame::kMass, {position, velocity, VectorXd::Zero(5)});
    PlannedInstant at;
    at.time_s = i * kSteps * kStep_s;
    at.position = mass.position;
    at.velocity = mass.velocity;
    at.acceleration = VectorXd::Zero(5);  // Nothing integrates it.
    at.drive_Nm = torque_Nm(at.time_s);
    phase.instants.push_back(at);
    for (int step = 0; step < kSteps; ++step) {
      // Held over a step: its mean is that at the middle, but for h^2/24 of the second derivative.
      const VectorXd held = torque_Nm(at.time_s + (step + 0.5) * kStep_s);
      for (Index row = 0; row < 2; ++row) mujoco.data().qfrc_applied[3 + row] = held[row];
      mj_step(&mujoco.model(), &mujoco.data());
    }
  }
  // 300/24 h^2 = 1e-7 Nm on 2.3e-3 kg m2 (shank and rotor of the knee) over 0.1 s: below 1e-6 rad.
  const PhaseError error = integration_errors(plane, {{"flight", {}}}, {{phase}}).front();
  EXPECT_LT(error.whole_rad, 1e-6);
  EXPECT_EQ(error.interval_rad.size(), 10u);
  // Torques that are a per cent greater are found out.
  for (PlannedInstant& at : phase.instants) at.drive_Nm *= 1.01;
  EXPECT_GT(integration_errors(plane, {{"flight", {}}}, {{phase}}).front().whole_rad, 1e-4);
}

}  // namespace
}  // namespace torquewright::hopper
