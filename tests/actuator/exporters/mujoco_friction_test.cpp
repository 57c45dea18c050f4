// SPDX-License-Identifier: Apache-2.0
// A joint driven by the exported file, friction in the joint. Oracle: the composed law of the
// actuator (actuator/region/torque_at.hpp, which `identify simulate` and the replay obey alike),
// and closed forms of dry and viscous friction; the simulator is MuJoCo itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "actuator/clip.hpp"
#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/exporter.hpp"
#include "actuator/exporters/simulator_file.hpp"
#include "actuator/region/torque_at.hpp"
#include "tests/actuator/exporters/example_actuators.hpp"
#include "tests/actuator/exporters/mujoco_simulation.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kOnePercent = 0.01;  // as issue 42 asks
constexpr double kCoulomb_Nm = 0.4;
constexpr double kViscous_Nm_s_rad = 0.02;
constexpr double kNewtonMetresPerAmpere = 6.0 * 0.32;
constexpr double kResistance_ohm = 0.28;
constexpr double kStep_s = 5e-5;  // a fraction of the motor's own 0.35 ms

const Parallelogram kMotor{329.142857142857, 25.0, 38.4};  // dry_drive's, by hand

/// What reaches the load of a commanded torque of the motor.
double composed_Nm(const Actuator& actuator, double command_Nm, double speed_rad_s) {
  Instant at;
  at.speed_rad_s = speed_rad_s;
  at.direction = std::copysign(1.0, speed_rad_s);
  at.current_A = clip(kMotor, speed_rad_s, command_Nm) / kNewtonMetresPerAmpere;
  return output_torque_Nm(actuator, at);
}

/// One hinge of MuJoCo, driven as the file says.
struct DrivenJoint : Simulation {
  explicit DrivenJoint(const SimulatorFile& file) : Simulation(file.text) {
    model->opt.timestep = kStep_s;
  }

  /// Asks the motor for a torque, through the voltage that the file controls.
  void command(double torque_Nm) {
    const double bias_Nm_s_rad = model->actuator_biasprm[2];
    data->ctrl[0] = (torque_Nm - bias_Nm_s_rad * data->qvel[0]) / model->actuator_gainprm[0];
  }

  /// All torque that reaches the inertia: motor, damping and friction loss.
  double load_Nm(double command_Nm, double speed_rad_s) {
    data->qvel[0] = speed_rad_s;
    command(command_Nm);
    mj_forward(model.get(), data.get());
    return data->qM[0] * data->qacc[0];
  }

  double inertia_kg_m2() {
    mj_forward(model.get(), data.get());
    return data->qM[0];
  }

  void step() { mj_step(model.get(), data.get()); }
};

struct Exported {
  explicit Exported(const Actuator& actuator)
      : drive(actuator, exporters::mujoco, {.friction = FrictionPlace::kJoint}),
        file(simulator_file(drive.subject(), exporters::mujoco, {})) {}
  ExportedDrive drive;
  SimulatorFile file;
};

constexpr const char* kQuadrants[] = {"speed > 0, driving", "speed > 0, braking",
                                      "speed < 0, braking", "speed < 0, driving"};
std::size_t quadrant_of(double speed_rad_s, double command_Nm) {
  return (speed_rad_s > 0.0 ? 0U : 2U) + (command_Nm > 0.0 ? 0U : 1U);
}

TEST(MujocoFriction, StandsInTheJointAsItWasMeant) {
  const DrivenJoint joint(Exported(dry_drive()).file);
  EXPECT_NEAR(joint.model->dof_frictionloss[0], kCoulomb_Nm, 1e-15);
  EXPECT_NEAR(joint.model->dof_damping[0], kViscous_Nm_s_rad, 1e-15);
  EXPECT_NEAR(joint.model->dof_armature[0], 36.0 * 1e-4, 1e-15);
  EXPECT_NEAR(joint.model->actuator_forcerange[1], 38.4, 1e-9);
}

// From 1 rad/s on: slower, 38.4 Nm on the 0.0046 kg m^2 of the file's stand-in would stop it within
// the constraint's two steps (docs/simulator_formats.md).
TEST(MujocoFriction, LetsTheComposedLawReachTheLoadInAllFourQuadrants) {
  const Actuator actuator = dry_drive();
  DrivenJoint joint(Exported(actuator).file);
  double worst[4] = {};
  for (int i = -24; i <= 24; ++i) {
    if (i == 0) continue;
    const double speed_rad_s = i;
    for (const double share : {-2.0, -1.0, -0.5, -0.1, 0.1, 0.5, 1.0, 2.0}) {
      const double command_Nm = share * 38.4;
      const double expected_Nm = composed_Nm(actuator, command_Nm, speed_rad_s);
      const double off = std::abs(joint.load_Nm(command_Nm, speed_rad_s) - expected_Nm) /
                         std::max(kCoulomb_Nm, std::abs(expected_Nm));
      double& so_far = worst[quadrant_of(speed_rad_s, command_Nm)];
      so_far = std::max(so_far, off);
    }
  }
  for (int i = 0; i < 4; ++i) {
    std::printf("MuJoCo, %s: load torque off by %.3g %%\n", kQuadrants[i], 100.0 * worst[i]);
    EXPECT_LE(worst[i], kOnePercent) << kQuadrants[i];
  }
}

// Oracle: closed form. Of a voltage V and a load torque L the speed comes to rest at
// (K V / R + L - c sign) / (K^2 / R + b), K = N Kt. A load that pushes beyond the no-load speed of
// its voltage, or against it, is braked.
TEST(MujocoFriction, SettlesAtTheSpeedsOfTheComposedLaw) {
  const Actuator actuator = dry_drive();
  const double gain_Nm_V = kNewtonMetresPerAmpere / kResistance_ohm;
  const double back_Nm_s_rad = kNewtonMetresPerAmpere * gain_Nm_V;
  double worst = 0.0;
  for (const double side : {1.0, -1.0}) {
    for (const auto& [volts, load_Nm] : {std::pair{4.0, 0.0},
                                         {12.0, 0.0},
                                         {40.0, 0.0},
                                         {40.0, -20.0},
                                         {10.0, 30.0},
                                         {2.0, 35.0},
                                         {-1.0, 30.0}}) {
      DrivenJoint joint(Exported(actuator).file);
      joint.data->ctrl[0] = side * volts;
      joint.data->qfrc_applied[0] = side * load_Nm;
      for (int i = 0; i < 4000; ++i) joint.step();
      const double motion = gain_Nm_V * volts + load_Nm > 0.0 ? 1.0 : -1.0;
      const double expected_rad_s = side * (gain_Nm_V * volts + load_Nm - kCoulomb_Nm * motion) /
                                    (back_Nm_s_rad + kViscous_Nm_s_rad);
      const double speed_rad_s = joint.data->qvel[0];
      const double off = std::abs(speed_rad_s / expected_rad_s - 1.0);
      worst = std::max(worst, off);
      EXPECT_LE(off, kOnePercent) << volts << " V, " << load_Nm << " Nm";
      // The drive's own law agrees that it is at rest there: its torque carries the load.
      const double motor_Nm = gain_Nm_V * side * volts - back_Nm_s_rad * expected_rad_s;
      EXPECT_NEAR(composed_Nm(actuator, motor_Nm, expected_rad_s), -side * load_Nm, 1e-9);
    }
  }
  std::printf("MuJoCo, steady speeds: off by %.3g %% at most\n", 100.0 * worst);
}

/// A coast from 20 rad/s, and how it was at its worst against w(t) = (w0 + c/b) exp(-b t / M) -
/// c/b, at rest at t = M/b ln(1 + b w0 / c): the closed form of w' = -(c + b w) / M.
struct RunDown {
  double worst_rad_s = 0.0;
  double slow_s = 0.0;           ///< Slower than a hundredth of the first speed from then on.
  double expected_slow_s = 0.0;  ///< The same of the closed form.
};
RunDown run_down(DrivenJoint& joint) {
  constexpr double kStart_rad_s = 20.0;
  constexpr double kDry_rad_s = kCoulomb_Nm / kViscous_Nm_s_rad;
  const double slow_rad_s = kOnePercent * kStart_rad_s;
  const double rate_1_s = kViscous_Nm_s_rad / joint.inertia_kg_m2();
  const auto time_s = [&](double speed_rad_s) {
    return std::log((kStart_rad_s + kDry_rad_s) / (speed_rad_s + kDry_rad_s)) / rate_1_s;
  };
  RunDown run{0.0, 0.0, time_s(slow_rad_s)};
  joint.data->qvel[0] = kStart_rad_s;
  while (joint.data->time < 2.0 * time_s(0.0)) {
    joint.command(0.0);
    joint.step();
    const double decay = std::exp(-rate_1_s * joint.data->time);
    const double expected_rad_s = std::max(0.0, (kStart_rad_s + kDry_rad_s) * decay - kDry_rad_s);
    run.worst_rad_s = std::max(run.worst_rad_s, std::abs(joint.data->qvel[0] - expected_rad_s));
    if (joint.data->qvel[0] > slow_rad_s) run.slow_s = joint.data->time;
  }
  return run;
}

// With the file's own stand-in at short steps, and with a link of 0.1 kg m^2 at MuJoCo's own 2 ms.
TEST(MujocoFriction, RunsDownAsDryAndViscousFrictionDo) {
  for (const auto& [link_kg_m2, step_s] : {std::pair{0.0, kStep_s}, {0.1, 2e-3}}) {
    DrivenJoint joint(Exported(dry_drive()).file);
    joint.model->opt.timestep = step_s;
    joint.model->dof_armature[0] += link_kg_m2;
    joint.model->dof_M0[0] += link_kg_m2;  // which MuJoCo takes for a joint alone
    ASSERT_NEAR(joint.inertia_kg_m2(), 0.0046 + link_kg_m2, 1e-6);
    const RunDown run = run_down(joint);
    std::printf(
        "MuJoCo, run-down at steps of %g s: off by %.3g %% of the first speed; at a "
        "hundredth of it after %.5g s of %.5g s\n",
        step_s, 100.0 * run.worst_rad_s / 20.0, run.slow_s, run.expected_slow_s);
    EXPECT_LE(run.worst_rad_s, kOnePercent * 20.0);
    EXPECT_NEAR(run.slow_s, run.expected_slow_s, kOnePercent * run.expected_slow_s + step_s);
    EXPECT_LE(std::abs(joint.data->qvel[0]), 1e-6);
  }
  EXPECT_NEAR(composed_Nm(dry_drive(), 0.0, 10.0), -kCoulomb_Nm - kViscous_Nm_s_rad * 10.0, 1e-12);
}

// What MuJoCo has no field for is in the error table: of a command of half the limit it is off by
// what is stated, and by no more.
TEST(MujocoFriction, StatesWhatLoadDependentFrictionTakesBelowTheLimits) {
  const Actuator actuator = loaded_drive();
  const Exported exported(actuator);
  DrivenJoint joint(exported.file);
  ASSERT_TRUE(exported.file.errors.at_half);
  double worst_Nm[4] = {};
  for (int i = -240; i <= 240; ++i) {
    if (std::abs(i) < 10) continue;
    const double speed_rad_s = 0.1 * i;
    const TorqueLimits limits = exporters::mujoco.law(exported.file.shape, speed_rad_s);
    for (const double command_Nm : {0.5 * limits.greatest_Nm, 0.5 * limits.least_Nm}) {
      const double off_Nm =
          joint.load_Nm(command_Nm, speed_rad_s) - composed_Nm(actuator, command_Nm, speed_rad_s);
      double& so_far = worst_Nm[quadrant_of(speed_rad_s, command_Nm)];
      so_far = std::max(so_far, std::abs(off_Nm));
    }
  }
  for (int i = 0; i < 4; ++i) {
    const QuadrantError& stated = (*exported.file.errors.at_half)[static_cast<std::size_t>(i)];
    const double stated_Nm = std::max(stated.optimistic.torque_Nm, stated.cautious.torque_Nm);
    std::printf("MuJoCo, half the limit, %s: off by %.4g Nm, stated %.4g Nm\n", kQuadrants[i],
                worst_Nm[i], stated_Nm);
    EXPECT_LE(worst_Nm[i], stated_Nm + 1e-3 * kCoulomb_Nm) << kQuadrants[i];
    EXPECT_GE(worst_Nm[i], 0.95 * stated_Nm) << kQuadrants[i];  // some of it lies below 1 rad/s
  }
}

/// The MJCF that stands in a module of Python.
std::string mjcf_in(const std::string& module) {
  const std::string mark = "MJCF = \"\"\"";
  const std::size_t begin = module.find(mark) + mark.size();
  return module.substr(begin, module.find("\"\"\"", begin) - begin);
}

// By hand: 36 1e-4 kg m^2; a control of 5 Nm is 5 Nm of the motor, of which 0.4 Nm and 0.02 Nm
// s/rad are lost, and one past the peak is the peak.
TEST(MujocoFriction, OfPlaygroundsJointIsThatOfTheDrive) {
  const ExportedDrive drive(dry_drive(), exporters::playground,
                            {.friction = FrictionPlace::kJoint});
  Simulation joint(mjcf_in(simulator_file(drive.subject(), exporters::playground, {}).text));
  joint.model->opt.timestep = kStep_s;
  EXPECT_NEAR(joint.model->dof_armature[0], 36e-4, 1e-15);
  for (const double speed_rad_s : {10.0, -10.0}) {
    for (const auto& [control_Nm, motor_Nm] : {std::pair{5.0, 5.0}, {-5.0, -5.0}, {99.0, 38.4}}) {
      EXPECT_NEAR(joint.force_Nm(speed_rad_s, control_Nm), motor_Nm, 1e-6 * 38.4);
      const double direction = std::copysign(1.0, speed_rad_s);
      EXPECT_NEAR(joint.data->qM[0] * joint.data->qacc[0],
                  motor_Nm - kCoulomb_Nm * direction - kViscous_Nm_s_rad * speed_rad_s,
                  kOnePercent * kCoulomb_Nm);
    }
  }
}

}  // namespace
}  // namespace torquewright::actuator
