// SPDX-License-Identifier: Apache-2.0
// What passes the gears in a run. Oracles: the check's own window, which knows no steps; Newton's
// law of a rotor and its load; areas by hand.
#include "hopper/record/load_window.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hopper/check/hopper_check.hpp"
#include "hopper/motion/motion_reader.hpp"
#include "hopper/record/step_window.hpp"
#include "robot/model/robot_spec.hpp"
#include "tests/hopper/replay/driven_robot.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Actuator;
using Eigen::Index;
using Eigen::VectorXd;

/// The same signal to the check: two samples a step, one time between two steps.
WindowLoad by_the_check(const StepSignal& signal, double window_s) {
  const Index steps = signal.values.size();
  std::vector<double> times_s;
  VectorXd values(2 * steps);
  VectorXd impulses = VectorXd::Zero(2 * steps);
  for (Index k = 0; k < steps; ++k) {
    const auto at = static_cast<std::size_t>(k);
    times_s.insert(times_s.end(), {signal.times_s[at], signal.times_s[at + 1]});
    values[2 * k] = values[2 * k + 1] = signal.values[k];
    impulses[2 * k + 1] = signal.impulses[k];
  }
  const VectorXd zero = VectorXd::Zero(2 * steps);
  return greatest_window({times_s, values, impulses, zero, zero}, window_s);
}

// Oracle: greatest_window of hopper/check, an independent search over the same windows.
TEST(StepWindow, IsThatOfTheCheck) {
  std::mt19937 dice(11);
  std::uniform_real_distribution<double> length(0.5, 1.5);
  std::normal_distribution<double> value;
  for (const double window_s : {0.4, 1.0, 7.3, 31.0, 1e3}) {
    for (int trial = 0; trial < 40; ++trial) {
      const bool is_even = trial % 2 == 0;
      std::vector<double> times_s{0.3};
      StepSignal signal{times_s, VectorXd(40), VectorXd::Zero(40)};
      for (Index k = 0; k < 40; ++k) {
        times_s.push_back(is_even ? 0.3 + static_cast<double>(k + 1)
                                  : times_s.back() + length(dice));
        signal.values[k] = value(dice);
        if (k % 9 == trial % 9) signal.impulses[k] = std::abs(value(dice));
      }
      const WindowLoad found = greatest_step_window(signal, window_s);
      const WindowLoad expected = by_the_check(signal, window_s);
      EXPECT_NEAR(found.mean, expected.mean, 1e-12) << window_s << " " << trial;
      EXPECT_NEAR(found.time_s, expected.time_s, 1e-9);
      EXPECT_NEAR(found.without_impulses, expected.without_impulses, 1e-9);
      EXPECT_EQ(found.doubt, 0.0);
      EXPECT_EQ(found.least, found.mean);
      EXPECT_EQ(found.most, found.mean);
    }
  }
}

constexpr double kRotor_kg_m2 = 1e-3;
constexpr double kAtOutput_kg_m2 = 100.0 * kRotor_kg_m2;

Robot robot_of(double ratio) {
  Actuator actuator = actuator::round_actuator();
  actuator.motor.rotor_inertia_kg_m2 = kRotor_kg_m2;
  actuator.transmission.ratio = ratio;
  actuator.transmission.forward_efficiency = 0.8;
  actuator.transmission.backward_efficiency = 0.5;
  Robot robot = driven_robot({actuator});
  robot.tree.bodies.resize(2);
  robot.drivetrains[0].rotors_in_tree = false;
  return robot;
}

/// 100 steps of 1 ms in which nothing happens.
DriveSteps quiet(double speed_rad_s) {
  DriveSteps steps;
  for (int i = 0; i <= 100; ++i) steps.times_s.push_back(1e-3 * i);
  steps.torque_Nm = steps.contact_Nm_s = Eigen::MatrixXd::Zero(1, 100);
  steps.speed_before_rad_s = Eigen::MatrixXd::Constant(1, 100, speed_rad_s);
  steps.speed_after_rad_s = steps.speed_before_rad_s;
  return steps;
}

// Oracle: Newton's law of rotor and load. A torque that only spins the rotor up passes no gear;
// that turns rotor and load, the load's part of it does.
TEST(LoadWindow, IsWhatTheRotorLeaves) {
  constexpr double kTorque_Nm = 7.0;
  for (const double load_kg_m2 : {0.0, 0.3}) {
    const double rate_rad_s2 = kTorque_Nm / (kAtOutput_kg_m2 + load_kg_m2);
    DriveSteps steps = quiet(0.0);
    steps.torque_Nm.setConstant(kTorque_Nm);
    for (Index k = 0; k < 100; ++k) {
      steps.speed_before_rad_s(0, k) = rate_rad_s2 * 1e-3 * static_cast<double>(k);
      steps.speed_after_rad_s(0, k) = rate_rad_s2 * 1e-3 * static_cast<double>(k + 1);
    }
    for (const double ratio : {10.0, -10.0}) {
      const TransmissionLoad load = transmission_loads(robot_of(ratio), steps, 0.01).at(0);
      const double passes_Nm = load_kg_m2 * rate_rad_s2;
      EXPECT_NEAR(load.joint.mean, passes_Nm, 1e-11);
      EXPECT_NEAR(load.motor.mean, passes_Nm / 0.8 / 10.0, 1e-11);  // driving
      EXPECT_NEAR(load.peak_joint_Nm, passes_Nm, 1e-11);
      EXPECT_NEAR(load.peak_motor_Nm, passes_Nm / 0.8 / 10.0, 1e-11);
      EXPECT_EQ(load.drive, "drive_1");
      EXPECT_EQ(load.ratio, 10.0);
      EXPECT_EQ(load.window_s, 0.01);
      EXPECT_EQ(load.rotor_Nm_s, 0.0);
    }
  }
}

// Oracle: areas. A load that is held back while the joint turns on is driven: the motor's side has
// half of it. 30 Nm for 4 ms among zeros mean 12 Nm over 10 ms.
TEST(LoadWindow, MeansOverItsWindowOnEitherSideOfTheMesh) {
  DriveSteps steps = quiet(2.0);
  for (Index k = 50; k < 54; ++k) steps.torque_Nm(0, k) = -30.0;
  Robot robot = robot_of(10.0);
  robot.drivetrains[0].transmission_limit = TransmissionLimit{0.5, GearSide::kMotor, "a test"};
  const TransmissionLoad load = transmission_loads(robot, steps, 0.01).at(0);
  EXPECT_NEAR(load.joint.mean, 12.0, 1e-9);
  EXPECT_NEAR(load.joint.time_s, 0.044, 1e-9);  // the first window that holds all of it
  EXPECT_NEAR(load.motor.mean, 0.5 * 1.2, 1e-10);
  EXPECT_EQ(load.verdict, actuator::Verdict::kFail);
  robot.drivetrains[0].transmission_limit->torque_Nm = 0.7;
  EXPECT_EQ(transmission_loads(robot, steps, 0.01).at(0).verdict, actuator::Verdict::kPass);
  // Over 2.5 ms all of it is 30 Nm; a run shorter than its window is one.
  EXPECT_NEAR(transmission_loads(robot, steps, 0.0025).at(0).joint.mean, 30.0, 1e-9);
  EXPECT_NEAR(transmission_loads(robot, steps, 7.0).at(0).joint.mean, 1.2, 1e-9);
  EXPECT_NEAR(transmission_loads(robot, steps, 7.0).at(0).window_s, 0.1, 1e-12);
}

// Oracle: eq. (17) by hand. A landing that drives the rotor from 2 to -3 rad/s passes 0.5 Nm s, 50
// Nm over 10 ms, alike on both sides; by its size where it is known for an impact, else by its
// sign.
TEST(LoadWindow, HoldsImpacts) {
  DriveSteps steps = quiet(2.0);
  steps.speed_after_rad_s(0, 60) = -3.0;
  for (Index k = 61; k < 100; ++k) {
    steps.speed_before_rad_s(0, k) = steps.speed_after_rad_s(0, k) = -3.0;
  }
  steps.torque_Nm.setConstant(-4.0);
  steps.contact_Nm_s(0, 60) = -1.5;
  steps.contact_Nm_s(0, 61) = 0.2;
  const double impulse_Nm_s = 5.0 * kAtOutput_kg_m2;
  const Robot robot = robot_of(10.0);
  EXPECT_NEAR(transmission_loads(robot, steps, 0.01).at(0).joint.mean, impulse_Nm_s / 0.01 - 4.0,
              1e-9);
  steps.has_impact.assign(100, false);
  steps.has_impact[60] = true;
  const TransmissionLoad load = transmission_loads(robot, steps, 0.01).at(0);
  EXPECT_NEAR(load.joint.mean, impulse_Nm_s / 0.01 + 4.0, 1e-9);
  EXPECT_NEAR(load.joint.without_impulses, 4.0, 1e-9);
  EXPECT_NEAR(load.peak_joint_Nm, 4.0, 1e-9);
  EXPECT_NEAR(load.rotor_Nm_s, impulse_Nm_s, 1e-12);
  EXPECT_NEAR(load.impact_time_s, 0.061, 1e-12);
  // Before it the torque brakes, and half of it comes from the motor; after it drives.
  EXPECT_NEAR(load.motor.mean, impulse_Nm_s / 0.01 / 10.0 + 4.0 / 0.8 / 10.0, 1e-9);
  const ContactLoad contact = contact_loads(robot, steps, 0.01).at(0);
  EXPECT_NEAR(contact.joint_Nm, 1.7 / 0.01, 1e-9);
  EXPECT_NEAR(contact.motor_Nm, 17.0, 1e-9);
  EXPECT_NEAR(contact.steady_joint_Nm, 0.2 / 0.01, 1e-9);
  EXPECT_NEAR(contact.impulse_Nm_s, 1.5, 1e-12);
  EXPECT_NEAR(contact.impulse_time_s, 0.061, 1e-12);
}

/// The flip's samples as the steps of a run: an impact is one of a nanosecond.
DriveSteps steps_of(const Motion& motion, const HopperReport& report) {
  constexpr double kAtOnce_s = 1e-9;
  const Index drives = report.torques_Nm.rows();
  const Index count = motion.samples() - 1;
  DriveSteps steps;
  steps.times_s.push_back(motion.time_s(0));
  steps.torque_Nm.resize(drives, count);
  steps.speed_before_rad_s = steps.speed_after_rad_s = steps.torque_Nm;
  steps.contact_Nm_s.setZero(drives, count);
  for (Index k = 0; k < count; ++k) {
    const bool is_impact = motion.time_s(k + 1) == motion.time_s(k);
    steps.times_s.push_back(motion.time_s(k + 1) + (is_impact ? kAtOnce_s : 0.0));
    steps.has_impact.push_back(is_impact);
    steps.torque_Nm.col(k) = 0.5 * (report.torques_Nm.col(k) + report.torques_Nm.col(k + 1));
    for (Index i = 0; i < drives; ++i) {
      const auto& drive = report.demand.drives[static_cast<std::size_t>(i)];
      steps.speed_before_rad_s(i, k) = drive[static_cast<std::size_t>(k)].speed_rad_s;
      steps.speed_after_rad_s(i, k) = drive[static_cast<std::size_t>(k) + 1].speed_rad_s;
    }
  }
  return steps;
}

// Oracle: `hopper check`, which takes the rotors' part from accelerations where a run takes it from
// changes of speed. They differ by no more than the check itself says that it leaves open.
TEST(LoadWindow, OfTheFlipIsWhatTheCheckFinds) {
  const std::string specs = TORQUEWRIGHT_SOURCE_DIR "/specs/";
  const Robot robot = read_robot(specs + "robot/hopper.json").robot;
  Motion motion = read_motion(robot, {specs + "trajectory/hopper_flip.csv", {}, {}, {}});
  const HopperReport report = check_motion(robot, motion, {});
  const auto loads = transmission_loads(robot, steps_of(motion, report), 0.01);
  ASSERT_EQ(loads.size(), report.transmission_loads.size());
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const TransmissionLoad& found = report.transmission_loads[i];
    EXPECT_LT(found.joint.doubt, 0.05 * found.joint.mean);
    EXPECT_NEAR(loads[i].joint.mean, found.joint.mean, found.joint.doubt) << found.drive;
    EXPECT_NEAR(loads[i].motor.mean, found.motor.mean, found.motor.doubt) << found.drive;
    EXPECT_NEAR(loads[i].rotor_Nm_s, found.rotor_Nm_s, 1e-9 + 1e-6 * found.rotor_Nm_s);
    EXPECT_EQ(loads[i].drive, found.drive);
    EXPECT_EQ(loads[i].verdict, found.verdict);
  }
}

TEST(LoadWindow, RefusesWhatIsNoRun) {
  const Robot robot = robot_of(10.0);
  const auto refuses = [&](auto change) {
    DriveSteps steps = quiet(0.0);
    change(steps);
    EXPECT_THROW(transmission_loads(robot, steps, 0.01), std::invalid_argument);
    EXPECT_THROW(contact_loads(robot, steps, 0.01), std::invalid_argument);
  };
  refuses([](DriveSteps& steps) { steps.times_s[5] = steps.times_s[4]; });
  refuses([](DriveSteps& steps) { steps.times_s.pop_back(); });
  refuses([](DriveSteps& steps) { steps.torque_Nm(0, 3) = NAN; });
  refuses([](DriveSteps& steps) { steps.contact_Nm_s.resize(2, 100); });
  refuses([](DriveSteps& steps) { steps.has_impact.assign(3, true); });
  EXPECT_THROW(transmission_loads(robot, quiet(0.0), 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace torquewright::hopper
