// SPDX-License-Identifier: Apache-2.0
// What passes the gears. Oracles: Newton's law of one arm and of a rotor in closed form, of a body
// that folds in flight, and of the flip's thigh alone, which needs no force of the ground.
#include "hopper/check/gear_torque.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "hopper/check/hopper_check.hpp"
#include "hopper/check/series.hpp"
#include "hopper/motion/motion_reader.hpp"
#include "robot/mechanisms/constant_jacobian.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Verdict;
using Eigen::Index;

constexpr double kRotor_kg_m2 = 1e-3;

Drivetrain drive_of(std::size_t joint, double ratio, double rotor_kg_m2) {
  Drivetrain drivetrain;
  drivetrain.mechanism = std::make_shared<ConstantJacobian>(direct_drive());
  drivetrain.joints = {joint};
  actuator::Actuator actuator;
  actuator.motor.torque_constant_Nm_A = 0.5;
  actuator.motor.resistance_ohm = 0.1;
  actuator.motor.rotor_inertia_kg_m2 = rotor_kg_m2;
  actuator.drive = {.bus_voltage_V = 100, .peak_current_A = 100, .continuous_current_A = {}};
  actuator.transmission.ratio = ratio;
  drivetrain.actuators = {actuator};
  drivetrain.actuator_names = {"drive"};
  drivetrain.actuator_files = {"drive.json"};
  drivetrain.rotors_in_tree = false;
  return drivetrain;
}

/// A balanced arm without weight on a fixed hinge.
Robot arm(double inertia_kg_m2, double ratio, double rotor_kg_m2) {
  Robot robot;
  robot.tree.gravity_m_s2 = 0.0;
  dynamics::Body body;
  body.joint.name = "hinge";
  body.inertia = {1.0, Eigen::Vector3d::Zero(), inertia_kg_m2 * Eigen::Matrix3d::Identity()};
  robot.tree.bodies = {dynamics::Body{}, body};
  robot.drivetrains = {drive_of(1, ratio, rotor_kg_m2)};
  return robot;
}

/// From a speed on at one acceleration, 1 ms a sample.
Motion steadily(double speed_rad_s, double rate_rad_s2) {
  Motion motion;
  for (int i = 0; i <= 50; ++i) motion.times_s.push_back(1e-3 * i);
  motion.positions.resize(1, motion.samples());
  motion.velocities.resize(1, motion.samples());
  for (Index i = 0; i < motion.samples(); ++i) {
    const double t = motion.time_s(i);
    motion.positions(0, i) = speed_rad_s * t + 0.5 * rate_rad_s2 * t * t;
    motion.velocities(0, i) = speed_rad_s + rate_rad_s2 * t;
  }
  motion.accelerations.setConstant(1, motion.samples(), rate_rad_s2);
  motion.efforts.setZero(1, motion.samples());
  motion.has_effort = {false};
  return motion;
}

/// A wheel on a body that floats without gravity, both centres on the axis; the rotor's spin
/// counts.
Robot wheel_in_space(double body_kg_m2, double wheel_kg_m2, double ratio, double rotor_kg_m2) {
  Robot robot = arm(wheel_kg_m2, ratio, rotor_kg_m2);
  robot.tree.base = dynamics::BaseKind::kPlanar;
  robot.tree.bodies[0].inertia = {3.0, Eigen::Vector3d::Zero(),
                                  body_kg_m2 * Eigen::Matrix3d::Identity()};
  robot.tree.bodies[1].joint.rotor_spin_kg_m2 = {0.0, ratio * rotor_kg_m2, 0.0};
  return robot;
}

// I q'' passes the gears, (I + N^2 J) q'' is the motor's: at any sign of speed, rate and ratio.
TEST(GearTorque, IsTheLoadsPartOfTheMotorsTorque) {
  constexpr double kArm = 0.2;
  for (const double ratio : {10.0, -10.0}) {
    for (const double speed : {8.0, -8.0}) {
      for (const double rate : {30.0, -30.0}) {
        const Robot robot = arm(kArm, ratio, kRotor_kg_m2);
        Motion motion = steadily(speed, rate);
        const HopperReport report = check_motion(robot, motion, {});
        for (Index i = 0; i < motion.samples(); ++i) {
          EXPECT_NEAR(report.torques_Nm(0, i), (kArm + 100 * kRotor_kg_m2) * rate, 1e-12);
          EXPECT_NEAR(report.gears.joint_Nm(0, i), kArm * rate, 1e-12);
          EXPECT_NEAR(report.gears.motor_Nm(0, i), kArm * rate / ratio, 1e-13);
        }
        const TransmissionLoad& load = report.transmission_loads.at(0);
        EXPECT_NEAR(load.joint.mean, 6.0, 1e-11);
        EXPECT_NEAR(load.motor.mean, 0.6, 1e-12);
        EXPECT_NEAR(load.peak_joint_Nm, 6.0, 1e-12);
        EXPECT_NEAR(load.joint.doubt, 0.0, 1e-11);
      }
    }
  }
}

// The joint's own damper, spring and friction are the drive's to overcome, and pass its gears.
TEST(GearTorque, HoldsWhatTheJointItselfTakes) {
  constexpr double kArm = 0.2, kRate = 30.0;
  for (const double speed : {8.0, -8.0}) {
    Robot robot = arm(kArm, 10.0, kRotor_kg_m2);
    robot.tree.bodies[1].joint.passive = {0.5, 2.0, 3.0, 40.0, 0.25};
    Motion motion = steadily(speed, kRate);
    const HopperReport report = check_motion(robot, motion, {});
    for (Index i = 0; i < motion.samples(); ++i) {
      const double own_Nm = 0.5 * motion.velocities(0, i) + 40.0 * (motion.positions(0, i) - 0.25) +
                            std::copysign(2.0, speed);
      EXPECT_NEAR(report.gears.joint_Nm(0, i), kArm * kRate + own_Nm, 1e-11);
      EXPECT_NEAR(report.torques_Nm(0, i), (kArm + 100 * kRotor_kg_m2) * kRate + own_Nm, 1e-11);
    }
  }
}

// A spring of 40 x 0.05 = 2 Nm: friction that holds 1.4 of it at rest leaves 0.6 to the drive, and
// one that holds 3 leaves nothing.
TEST(GearTorque, IsHeldByFrictionAtRest) {
  for (const double limit_Nm : {1.4, 3.0}) {
    Robot robot = arm(0.2, 10.0, kRotor_kg_m2);
    robot.tree.bodies[1].joint.passive = {0.5, 1.0, limit_Nm, 40.0, 0.05};
    Motion motion = steadily(0.0, 0.0);
    const HopperReport report = check_motion(robot, motion, {});
    EXPECT_NEAR(report.torques_Nm(0, 20), std::min(0.0, limit_Nm - 2.0), 1e-12);
  }
}

// A rotor alone: whatever its motor makes, nothing passes gears that turn no load.
TEST(GearTorque, IsNoneWhereTheRotorTurnsAlone) {
  Robot robot = arm(1e-12, 10.0, kRotor_kg_m2);
  robot.drivetrains[0].transmission_limit = {1e-6, GearSide::kJoint, "stated"};
  Motion motion = steadily(0.0, 200.0);
  const HopperReport report = check_motion(robot, motion, {});
  EXPECT_NEAR(report.torques_Nm(0, 20), 20.0, 1e-9);
  EXPECT_LE(report.gears.joint_Nm.cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_EQ(report.transmission_loads[0].verdict, Verdict::kPass);
}

// The gears' own inertia lies behind the first mesh: it passes the teeth, the rotor's does not.
TEST(GearTorque, HoldsWhatTheGearsThemselvesTake) {
  Robot robot = arm(0.2, 10.0, kRotor_kg_m2);
  robot.drivetrains[0].actuators[0].transmission.inertia_kg_m2 = 0.05;
  Motion motion = steadily(0.0, 40.0);
  const HopperReport report = check_motion(robot, motion, {});
  EXPECT_NEAR(report.torques_Nm(0, 20), (0.2 + 0.1 + 0.05) * 40.0, 1e-12);
  EXPECT_NEAR(report.gears.joint_Nm(0, 20), (0.2 + 0.05) * 40.0, 1e-12);
}

// Order of losses: before the mesh the motor's side carries more where it drives and less where it
// is driven; friction on the motor's side never reaches the teeth.
TEST(GearTorque, LosesInTheMeshAsTheMotionGoes) {
  Robot robot = arm(0.2, 10.0, kRotor_kg_m2);
  robot.drivetrains[0].actuators[0].transmission.forward_efficiency = 0.8;
  robot.drivetrains[0].actuators[0].transmission.backward_efficiency = 0.7;
  for (const double way : {1.0, -1.0}) {
    Motion driving = steadily(5.0 * way, 30.0 * way);
    Motion driven = steadily(5.0 * way, -30.0 * way);
    EXPECT_NEAR(check_motion(robot, driving, {}).gears.motor_Nm(0, 9), way * 6.0 / 0.8 / 10, 1e-12);
    EXPECT_NEAR(check_motion(robot, driven, {}).gears.motor_Nm(0, 9), -way * 6.0 * 0.7 / 10, 1e-12);
  }
}

// Torques of the file are the motor's: the rotor's part is taken from them as from the dynamics'.
TEST(GearTorque, OfTheFilesTorquesIsWithoutTheRotors) {
  const Robot robot = arm(0.2, 10.0, kRotor_kg_m2);
  for (const bool holds_rotor : {true, false}) {
    Motion motion = steadily(0.0, 30.0);
    motion.has_effort = {true};
    motion.efforts.setConstant(1, motion.samples(), (holds_rotor ? 0.3 : 0.2) * 30.0);
    const HopperReport report = check_motion(robot, motion, {});
    EXPECT_NEAR(report.gears.joint_Nm(0, 20), 6.0, 1e-11);
  }
}

// Samples whose torques the motion contradicts by 2 Nm know the load to 2 Nm. It is 8: the verdict
// is open between 6 and 10.
TEST(TransmissionLoad, IsUndecidedWhereTheSamplesContradictEachOther) {
  Robot robot = arm(0.2, 10.0, kRotor_kg_m2);
  const std::vector<std::pair<double, Verdict>> cases{{5.9, Verdict::kFail},
                                                      {6.1, Verdict::kUndecided},
                                                      {9.9, Verdict::kUndecided},
                                                      {10.1, Verdict::kPass}};
  for (const auto& [limit_Nm, verdict] : cases) {
    robot.drivetrains[0].transmission_limit = {limit_Nm, GearSide::kJoint, "stated"};
    Motion motion = steadily(0.0, 30.0);
    motion.has_effort = {true};
    motion.efforts.setConstant(1, motion.samples(), 9.0 + 2.0);
    const HopperReport report = check_motion(robot, motion, {});
    const TransmissionLoad& load = report.transmission_loads[0];
    EXPECT_NEAR(load.joint.mean, 8.0, 1e-11);
    EXPECT_NEAR(load.joint.least, 6.0, 1e-11);
    EXPECT_NEAR(load.joint.most, 10.0, 1e-11);
    EXPECT_EQ(load.verdict, verdict) << limit_Nm;
    EXPECT_EQ(report.check.verdict, verdict) << limit_Nm;
    EXPECT_NEAR(load.doubt_Nm_s, 2e-3, 1e-12);  // in every millisecond
  }
}

// A jump of torque between two samples: wherever it lies in the interval, the mean of the true
// torque lies within the doubt.
TEST(TransmissionLoad, IsAsDoubtfulAsAJumpBetweenSamplesMakesIt) {
  const Robot robot = arm(0.2, 10.0, 0.0);
  Motion motion = steadily(0.0, 0.0);
  constexpr Index kLast = 25;  // sample before the jump
  for (const double share : {0.01, 0.5, 0.99}) {
    const double jump_s = motion.time_s(kLast) + 1e-3 * share;
    for (Index i = 0; i < motion.samples(); ++i) {
      const double t = std::max(0.0, motion.time_s(i) - jump_s);
      motion.accelerations(0, i) = i > kLast ? 40.0 : 0.0;
      motion.velocities(0, i) = 40.0 * t;
      motion.positions(0, i) = 20.0 * t * t;
    }
    CheckOptions options;
    options.load_window_s = 2e-3;
    const HopperReport report = check_motion(robot, motion, options);
    const GearTorque& gears = report.gears;
    const double sampled_Nm_s =
        0.5 * 1e-3 * (gears.joint_Nm(0, kLast) + gears.joint_Nm(0, kLast + 1));
    const double true_Nm_s = 0.2 * 40.0 * 1e-3 * (1.0 - share);
    EXPECT_NEAR(gears.doubt_Nm_s(0, kLast + 1), true_Nm_s - sampled_Nm_s, 1e-12) << share;
    EXPECT_GE(gears.bend_Nm_s(0, kLast + 1), std::abs(true_Nm_s - sampled_Nm_s)) << share;
  }
}

// Torques that may be off by 0.7 Nm, all the time and all one way: so may each mean of 6 Nm.
TEST(TransmissionLoad, IsAsDoubtfulAsItsTorques) {
  struct Case {
    double limit_Nm;
    Verdict verdict;
  };
  constexpr double kDoubt_Nm = 0.7;
  for (const auto& [limit_Nm, verdict] :
       {Case{5.2, Verdict::kFail}, Case{5.4, Verdict::kUndecided}, Case{6.6, Verdict::kUndecided},
        Case{6.8, Verdict::kPass}}) {
    Robot robot = arm(0.2, 10.0, kRotor_kg_m2);
    robot.drivetrains[0].transmission_limit = {limit_Nm, GearSide::kJoint, "stated"};
    Motion motion = steadily(0.0, 30.0);
    const HopperReport report = check_motion(robot, motion, {});
    motion.acceleration_origin = Origin::kDerived;
    const CheckOptions options;
    const CheckedMotion checked{robot, options, motion, report.contacts, report.demand};
    DriveTorques torques = drive_torques(checked);
    torques.doubt_Nm.setConstant(1, motion.samples(), kDoubt_Nm);
    const TransmissionLoad load = transmission_loads(checked, gear_torque(checked, torques)).at(0);
    EXPECT_NEAR(load.joint.mean, 6.0, 1e-11);
    EXPECT_NEAR(load.joint.least, 6.0 - kDoubt_Nm, 1e-11);
    EXPECT_NEAR(load.joint.most, 6.0 + kDoubt_Nm, 1e-11);
    EXPECT_NEAR(load.motor.most, 0.6 + kDoubt_Nm / 10.0, 1e-12);
    EXPECT_EQ(load.verdict, verdict) << limit_Nm;
  }
}

/// Two bodies of 3 kg that share their centre of mass, where the hinge is, in free fall.
Robot folding(double limit_Nm) {
  Robot robot;
  robot.tree.base = dynamics::BaseKind::kPlanar;
  dynamics::Body base;
  base.inertia = {3.0, Eigen::Vector3d::Zero(), 0.3 * Eigen::Matrix3d::Identity()};
  dynamics::Body arm = base;
  arm.joint.name = "hinge";
  arm.inertia.inertia_kg_m2 = 0.6 * Eigen::Matrix3d::Identity();
  robot.tree.bodies = {base, arm};
  robot.contacts.push_back({"foot", {0, Eigen::Vector3d(0, 0, -0.1)}, 0.6, 0});
  robot.drivetrains = {drive_of(1, 10.0, kRotor_kg_m2)};
  robot.drivetrains[0].transmission_limit = {limit_Nm, GearSide::kJoint, "stated"};
  return robot;
}

// Without momentum the base turns back by a third of what both turn: 0.3 p + 0.6 (p + q) = 0. The
// hinge's torque is then 0.3 * 0.6 / 0.9 q'' = 0.2 q'', and 0.1 q'' more turns the rotor: with 80
// rad/s2 the motor makes 24 Nm and the gears pass 16 Nm. Nothing touches anything.
TEST(TransmissionLoad, OfAFlightIsThatOfItsMotor) {
  constexpr double kRate_rad_s2 = 80.0;
  constexpr double kPulse_rad_s = 20.0;
  for (const double limit_Nm : {0.1, 15.9, 16.1}) {
    const Robot robot = folding(limit_Nm);
    Motion motion;
    for (int i = 0; i <= 300; ++i) motion.times_s.push_back(1e-3 * i);
    motion.positions.resize(4, motion.samples());
    motion.velocities.resize(4, motion.samples());
    motion.accelerations.resize(4, motion.samples());
    for (Index i = 0; i < motion.samples(); ++i) {
      const double t = motion.time_s(i);
      const double angle =
          -kRate_rad_s2 / (kPulse_rad_s * kPulse_rad_s) * std::sin(kPulse_rad_s * t);
      const double speed = -kRate_rad_s2 / kPulse_rad_s * std::cos(kPulse_rad_s * t);
      const double rate = kRate_rad_s2 * std::sin(kPulse_rad_s * t);
      constexpr double kBack = -0.6 / 0.9;
      motion.positions.col(i) << 0, 5 - 0.5 * 9.81 * t * t, kBack * angle, angle;
      motion.velocities.col(i) << 0, -9.81 * t, kBack * speed, speed;
      motion.accelerations.col(i) << 0, -9.81, kBack * rate, rate;
    }
    motion.efforts.setZero(1, motion.samples());
    motion.has_effort = {false};
    const HopperReport report = check_motion(robot, motion, {});
    EXPECT_NEAR(report.torques_Nm.cwiseAbs().maxCoeff(), 24.0,
                24.0 * 5e-5);  // samples at the crest
    EXPECT_NEAR(report.gears.joint_Nm.cwiseAbs().maxCoeff(), 16.0, 16.0 * 5e-5);
    // The mean over 10 ms about a crest of the sine: sin(x)/x of x = 0.1; trapezoids lose h^2/12.
    EXPECT_NEAR(report.transmission_loads[0].joint.mean, 16.0 * std::sin(0.1) / 0.1, 16.0 * 1e-4);
    EXPECT_EQ(report.contact_loads.at(0).joint_Nm, 0.0);
    const bool is_beyond = limit_Nm < 15.97;
    EXPECT_EQ(report.transmission_loads[0].verdict, is_beyond ? Verdict::kFail : Verdict::kPass);
    const bool is_said = std::any_of(report.check.findings.begin(), report.check.findings.end(),
                                     [](const Finding& finding) {
                                       return finding.rule == "transmission-load" &&
                                              finding.severity == actuator::Severity::kViolation;
                                     });
    EXPECT_EQ(is_said, is_beyond);
  }
}

class FlipGears : public testing::Test {
 protected:
  static std::string specs(const char* file) {
    return std::string(TORQUEWRIGHT_SOURCE_DIR "/specs/") + file;
  }
  ReadRobot robot = read_robot(specs("robot/hopper.json"));
  Motion motion = read_motion(robot.robot, {specs("trajectory/hopper_flip.csv"), {}, {}, {}});
  HopperReport report = check_motion(robot.robot, motion, {});
};

// The thigh alone: 7.6 kg at 0.22 m above the knee, 0.335 kg m2, moved by its weight and the knee
// (the four-bar is 1:1). Its moment about the knee, whose acceleration is the base's:
//   -tau = (I + m c^2) q'' + m (c x (a - g)) about y.
// Columns have nine digits, accelerations reach 1e3: 1e-6 each, over the thigh 1e-5 Nm. The tool
// comes from below, by way of the ground's forces; what they leave over acts within a metre.
TEST_F(FlipGears, PassWhatMovesTheThigh) {
  constexpr double kMass = 7.6, kArm = 0.22, kInertia = 0.335;
  for (Index i = 0; i < motion.samples(); ++i) {
    const double pitch = 2.0 * std::atan2(motion.positions(5, i), motion.positions(3, i));
    const double x = kArm * std::sin(pitch), z = kArm * std::cos(pitch);
    const double moment_Nm =
        (kInertia + kMass * kArm * kArm) * motion.accelerations(4, i) +
        kMass * (z * motion.accelerations(0, i) - x * (motion.accelerations(2, i) + 9.81));
    const double left_Nm = report.demand.residual.col(i).norm();
    ASSERT_NEAR(report.gears.joint_Nm(0, i), -moment_Nm, 1e-4 + left_Nm) << motion.time_s(i);
    EXPECT_LE(left_Nm, 0.5);  // of forces of 1000 N: else nothing was compared
  }
}

// Figures of a program apart that integrates the above over windows 10 us apart: 12.38136 Nm from
// 0.60495 s, 13.94954 Nm at most, 0.61186 Nm s for the rotor at touch-down.
TEST_F(FlipGears, HoldAndTheLandingIsNotTheirWorst) {
  const TransmissionLoad& knee = report.transmission_loads.at(0);
  EXPECT_NEAR(knee.motor.mean, 12.38136, 2e-5);
  EXPECT_NEAR(knee.motor.time_s, 0.60495, 2e-5);
  EXPECT_NEAR(knee.peak_motor_Nm, 13.94954, 1e-5);
  EXPECT_NEAR(knee.rotor_Nm_s, 0.61186, 1e-5);
  EXPECT_NEAR(knee.impact_time_s, 1.1339, 1e-6);
  EXPECT_EQ(knee.verdict, Verdict::kPass);
  EXPECT_NEAR(report.contact_loads.at(0).motor_Nm, 17.54, 5e-3);  // the seed's figure, no verdict
}

/// The series of the hopper that holds the squat's first posture, where a knee at rest is said to
/// turn this fast to and fro.
Series held_series(const Robot& robot, double knee_rad_s) {
  Motion motion = read_motion(
      robot, {TORQUEWRIGHT_SOURCE_DIR "/specs/trajectory/hopper_squat.csv", {}, {}, {}});
  motion.positions = motion.positions.col(0).replicate(1, motion.samples()).eval();
  motion.velocities.setZero(9, motion.samples());
  motion.velocity_origin = Origin::kGiven;
  for (Eigen::Index i = 0; i < motion.samples(); ++i) {
    motion.velocities(6, i) = i % 2 == 0 ? knee_rad_s : -knee_rad_s;
  }
  const CheckOptions options;
  const HopperReport report = check_motion(robot, motion, options);
  return series_of(robot, motion, options, report, SeriesDetail::kDrives);
}

// Oracle: a knee at rest is at rest, whichever way rounding has it turn.
TEST(Series, AtAStopTakesNoSideOfRounding) {
  Robot robot = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  actuator::Transmission& gears = robot.drivetrains.at(0).actuators.at(0).transmission;
  gears.forward_efficiency = 0.8;
  gears.backward_efficiency = 0.75;
  const Series still = held_series(robot, 0.0), rounded = held_series(robot, 1e-17);
  for (const char* header : {"knee_torque_margin_Nm", "knee_torque_max_Nm", "knee_torque_min_Nm",
                             "knee_current_A", "knee_bus_voltage_V"}) {
    const double apart =
        (*find_column(still, header) - *find_column(rounded, header)).cwiseAbs().maxCoeff();
    EXPECT_LT(apart, 1e-9) << header;
  }
}

// Columns of the series are what the report summarises.
TEST_F(FlipGears, StandInTheSeries) {
  CheckOptions options;
  const Series series = series_of(robot.robot, motion, options, report, SeriesDetail::kDrives);
  const auto column = [&](const std::string& header) -> const Eigen::VectorXd& {
    return *find_column(series, header);
  };
  EXPECT_EQ(column("knee_gear_motor_torque_Nm"), report.gears.motor_Nm.row(0).transpose());
  EXPECT_NEAR(column("knee_current_A").cwiseAbs().maxCoeff(),
              report.check.drives[0].interpretation.peak_current_A, 1e-9);
  EXPECT_NEAR(column("knee_torque_margin_Nm").minCoeff(),
              report.check.drives[0].interpretation.margin_Nm,
              1e-3 * std::abs(report.check.drives[0].interpretation.margin_Nm));
  EXPECT_NEAR(column("knee_bus_voltage_V").minCoeff(), report.buses.at(0).least_V, 1e-9);
  EXPECT_EQ(column("impact").sum(), 1.0);
  EXPECT_NEAR(column("angular_momentum_y_Nm_s")[600], 6.35, 5e-3);
  EXPECT_EQ(find_column(series, "hip_current_A"), nullptr);
  double impulse_N_s = 0.0;
  for (const ContactPoint& point : robot.robot.contacts) {
    impulse_N_s += column(point.name + "_impulse_z_N_s").sum();
  }
  double jolts_N_s = 0.0;
  for (const Jolt& jolt : report.demand.jolts) {
    for (Index i = 2; i < jolt.impulses_N_s.size(); i += 3) jolts_N_s += jolt.impulses_N_s[i];
  }
  EXPECT_GT(impulse_N_s, 1.0);
  EXPECT_NEAR(impulse_N_s, jolts_N_s, 1e-12 * jolts_N_s);
  const std::string csv = series_csv(series);
  EXPECT_EQ(static_cast<Index>(std::count(csv.begin(), csv.end(), '\n')), motion.samples() + 1);
}

// Oracle: the gears alone turn the wheel in space, I_w (a_b + q''), and the rotor takes
// J (a_b + N q'') of the motor; the body turns by the momentum of both, (I_b + I_w) a_b = -(I_w + N
// J) q''.
TEST(GearTorque, OfARotorWhoseCarrierTurnsIsTheLoadsToo) {
  constexpr double kBody = 0.08, kWheel = 0.006, kRotor = 0.01, kRate = 96.0;
  for (const double ratio : {2.0, -2.0}) {
    const Robot robot = wheel_in_space(kBody, kWheel, ratio, kRotor);
    const double turning = -(kWheel + ratio * kRotor) * kRate / (kBody + kWheel);
    Motion motion = steadily(0.0, 0.0);
    motion.has_base = true;
    for (Eigen::MatrixXd* table : {&motion.positions, &motion.velocities, &motion.accelerations}) {
      table->setZero(4, motion.samples());
    }
    for (Index i = 0; i < motion.samples(); ++i) {
      const double t = motion.time_s(i);
      motion.positions.col(i).tail<2>() << 0.5 * turning * t * t, 0.5 * kRate * t * t;
      motion.velocities.col(i).tail<2>() << turning * t, kRate * t;
      motion.accelerations.col(i).tail<2>() << turning, kRate;
    }
    const HopperReport report = check_motion(robot, motion, {});
    const double load_Nm = kWheel * (turning + kRate);
    for (Index i = 0; i < motion.samples(); ++i) {
      EXPECT_NEAR(report.gears.joint_Nm(0, i), load_Nm, 1e-9);
      EXPECT_NEAR(report.torques_Nm(0, i),
                  load_Nm + ratio * kRotor * turning + ratio * ratio * kRotor * kRate, 1e-9);
    }
  }
}

}  // namespace
}  // namespace torquewright::hopper
