// SPDX-License-Identifier: Apache-2.0
// Flights, contact loads, shared batteries, the choice of torques and what is left over, of
// demands written by hand.
// Oracles: areas of trapezoids, means by hand, Kirchhoff's quadratic.
#include <gtest/gtest.h>

#include <cmath>

#include "actuator/effects/library.hpp"
#include "hopper/check/physical.hpp"
#include "hopper/demand/base_residual.hpp"
#include "hopper/demand/battery_charge.hpp"
#include "hopper/demand/contact_load.hpp"
#include "hopper/demand/drive_reports.hpp"
#include "hopper/demand/free_rows.hpp"
#include "hopper/demand/shared_bus.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/mechanisms/constant_jacobian.hpp"
#include "tests/actuator/check/simple_actuator.hpp"
#include "tests/actuator/example_actuator.hpp"
#include "tests/hopper/check/made_motion.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

/// A floating body with one foot, and two drives of ratio 10 and -10 on two hinges.
struct DrivenMotion : check_test::MadeMotion {
  explicit DrivenMotion(Index samples) {
    robot.tree.base = dynamics::BaseKind::kPlanar;
    robot.tree.bodies.resize(3);
    robot.contacts.push_back({"foot", {0, Eigen::Vector3d::Zero()}, 0.6, 0.0});
    for (const std::size_t joint : {1u, 2u}) {
      Drivetrain drivetrain;
      drivetrain.mechanism = std::make_shared<ConstantJacobian>(direct_drive());
      drivetrain.joints = {joint};
      drivetrain.actuators = {actuator::round_actuator()};
      drivetrain.actuators[0].transmission.ratio = joint == 1 ? 10.0 : -10.0;
      drivetrain.actuator_names = {joint == 1 ? "one" : "two"};
      robot.drivetrains.push_back(drivetrain);
    }
    for (Index i = 0; i < samples; ++i) motion.times_s.push_back(0.01 * static_cast<double>(i));
    contacts.touches.setConstant(1, samples, true);
    demand.drives.assign(2, std::vector<DriveInstant>(motion.times_s.size()));
    demand.contact_Nm.setZero(2, samples);
    demand.center_of_mass_m.setZero(3, samples);
    demand.angular_momentum_Nm_s.setZero(3, samples);
    demand.angular_velocity_rad_s.setZero(3, samples);
    demand.weight_N = 100.0;
    demand.size_m = 0.5;
    demand.rows = {2, 1, 1};
    demand.residual.setZero(4, samples);
  }
};

TEST(Flights, AreTheStretchesOfTwoSamplesAndMoreWithoutContact) {
  DrivenMotion driven(9);
  for (const Index sample : {1, 3, 4, 5, 7, 8}) driven.contacts.touches(0, sample) = false;
  driven.demand.center_of_mass_m.row(2) << 9, 9, 9, 0.5, 0.8, 0.6, 9, 1.0, 0.9;
  driven.demand.angular_momentum_Nm_s.row(1) << 9, 9, 9, 5.0, 6.0, 7.0, 9, -4.0, -4.0;
  driven.demand.angular_velocity_rad_s.row(1) << 9, 9, 9, -7.0, 8.0, 7.5, 9, -3.0, -2.0;
  const std::vector<Flight> found = flights(driven.checked());
  ASSERT_EQ(found.size(), 2u);
  EXPECT_DOUBLE_EQ(found[0].from_s, 0.03);
  EXPECT_DOUBLE_EQ(found[0].until_s, 0.05);
  EXPECT_DOUBLE_EQ(found[0].angular_momentum_Nm_s, 6.0);
  EXPECT_DOUBLE_EQ(found[0].angular_momentum_drift_Nm_s, 1.0);
  EXPECT_DOUBLE_EQ(found[0].take_off_rad_s, 7.0);
  EXPECT_DOUBLE_EQ(found[0].peak_rad_s, 8.0);
  EXPECT_DOUBLE_EQ(found[0].touch_down_rad_s, 7.5);
  EXPECT_DOUBLE_EQ(found[0].rise_m, 0.8 - 0.5);
  EXPECT_DOUBLE_EQ(found[1].until_s, 0.08);
  EXPECT_DOUBLE_EQ(found[1].angular_momentum_Nm_s, 4.0);
  EXPECT_DOUBLE_EQ(found[1].touch_down_rad_s, 2.0);
  EXPECT_DOUBLE_EQ(found[1].rise_m, 0.0);
}

TEST(Flights, NeedABaseThatMovesAndSomethingThatCouldTouch) {
  DrivenMotion driven(4);
  driven.contacts.touches.setConstant(false);
  EXPECT_EQ(flights(driven.checked()).size(), 1u);
  driven.demand.has_dynamics = false;
  EXPECT_TRUE(flights(driven.checked()).empty());
  driven.demand.has_dynamics = true;
  driven.robot.tree.base = dynamics::BaseKind::kFixed;
  EXPECT_TRUE(flights(driven.checked()).empty());
}

// Oracle: areas. 30 Nm at one sample among zeros are a triangle of 30 * 10 ms: windows of 20 ms
// that begin 10 ms before it mean 15 Nm. A jolt of -0.5 Nm s in the same window adds 25 Nm.
TEST(ContactLoad, HoldsSteadyPartAndJoltOfItsWindow) {
  DrivenMotion driven(8);
  driven.options.load_window_s = 0.02;
  driven.demand.contact_Nm(1, 3) = -30.0;
  Jolt jolt;
  jolt.sample = 3;
  jolt.time_s = 0.03;
  jolt.contact_Nm_s = Eigen::Vector2d(0.0, -0.5);
  Jolt lesser = jolt;
  lesser.sample = 6;
  lesser.time_s = 0.06;
  lesser.contact_Nm_s[1] = 0.1;
  driven.demand.jolts = {jolt, lesser};
  const std::vector<ContactLoad> loads = contact_loads(driven.checked());
  ASSERT_EQ(loads.size(), 2u);
  EXPECT_EQ(loads[0].joint_Nm, 0.0);
  EXPECT_EQ(loads[0].impulse_Nm_s, 0.0);
  const ContactLoad& load = loads[1];
  EXPECT_EQ(load.drive, "two");
  EXPECT_EQ(load.ratio, 10.0);
  EXPECT_NEAR(load.joint_Nm, 15.0 + 25.0, 1e-12);
  EXPECT_NEAR(load.motor_Nm, 4.0, 1e-12);
  EXPECT_NEAR(load.steady_joint_Nm, 15.0, 1e-12);
  EXPECT_DOUBLE_EQ(load.time_s, 0.02);
  EXPECT_DOUBLE_EQ(load.impulse_Nm_s, 0.5);
  EXPECT_DOUBLE_EQ(load.impulse_time_s, 0.03);
  driven.demand.has_dynamics = false;
  EXPECT_TRUE(contact_loads(driven.checked()).empty());
}

/// Both drives on 50 V behind 0.1 ohm.
DrivenMotion on_one_battery(Index samples) {
  DrivenMotion driven(samples);
  actuator::Battery battery;
  battery.cell_open_circuit = {{1.0, 50.0}};
  battery.cell_resistance_ohm = 0.1;
  for (Drivetrain& drivetrain : driven.robot.drivetrains) drivetrain.actuators[0].battery = battery;
  return driven;
}

/// Power of one drive: N K i = torque, 0.5 ohm.
double power_W(double torque_Nm, double speed_rad_s) {
  const double current_A = torque_Nm / 10.0 / 0.5;
  return torque_Nm * speed_rad_s + 0.5 * current_A * current_A;
}

// Oracle: Kirchhoff. The bus stands at the larger root of V^2 - 50 V + 0.1 P = 0, P the sum.
TEST(SharedBus, SagsUnderTheSumOfItsDrives) {
  DrivenMotion driven = on_one_battery(4);
  Eigen::MatrixXd torques_Nm(2, 4);
  torques_Nm << 0.0, 50.0, 80.0, -60.0,  //
      0.0, 40.0, 70.0, 20.0;
  for (std::size_t sample = 0; sample < 4; ++sample) {
    driven.demand.drives[0][sample].speed_rad_s = 4.0;
    driven.demand.drives[1][sample].speed_rad_s = 3.0;
  }
  const std::vector<SharedBus> buses = shared_buses(driven.checked(), torques_Nm);
  ASSERT_EQ(buses.size(), 1u);
  const SharedBus& bus = buses[0];
  EXPECT_EQ(bus.drives, (std::vector<std::size_t>{0, 1}));
  for (Index i = 0; i < 4; ++i) {
    const double sum_W = power_W(torques_Nm(0, i), 4.0) + power_W(torques_Nm(1, i), 3.0);
    EXPECT_NEAR(bus.voltage_V[i], 25.0 + std::sqrt(625.0 - 0.1 * sum_W), 1e-10) << i;
  }
  EXPECT_GT(bus.voltage_V[3], 50.0);  // braking returns more than the other draws
  EXPECT_EQ(bus.open_circuit_V, 50.0);
  EXPECT_EQ(bus.least_V, bus.voltage_V[2]);
  EXPECT_DOUBLE_EQ(bus.least_time_s, 0.02);
  EXPECT_NEAR(bus.greatest_power_W, power_W(80.0, 4.0) + power_W(70.0, 3.0), 1e-9);
  EXPECT_DOUBLE_EQ(bus.power_time_s, 0.02);
  EXPECT_EQ(bus.starved, 0u);
  const std::vector<Finding> findings = shared_bus_findings(driven.checked(), buses);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].rule, "shared-battery");
  EXPECT_EQ(findings[0].severity, actuator::Severity::kNote);
  EXPECT_EQ(*findings[0].value, bus.least_V);
  EXPECT_DOUBLE_EQ(*findings[0].time_s, 0.02);
}

// 10 A at most: 10 (50 - 1) = 490 W. One drive alone, or another battery, shares nothing.
TEST(SharedBus, CountsTheSamplesWhosePowerIsTooMuch) {
  DrivenMotion driven = on_one_battery(3);
  for (Drivetrain& drivetrain : driven.robot.drivetrains) {
    drivetrain.actuators[0].battery->discharge_limit_A = 10.0;
  }
  for (std::size_t sample = 0; sample < 3; ++sample) {
    driven.demand.drives[0][sample].speed_rad_s = driven.demand.drives[1][sample].speed_rad_s = 4.0;
  }
  Eigen::MatrixXd torques_Nm(2, 3);
  torques_Nm << 45.0, 50.0, 55.0,  // 220.5, 250 and 280.5 W
      45.0, 50.0, 55.0;
  const std::vector<SharedBus> buses = shared_buses(driven.checked(), torques_Nm);
  ASSERT_EQ(buses.size(), 1u);
  EXPECT_EQ(buses[0].starved, 2u);
  EXPECT_NEAR(buses[0].power_limit_W, 490.0, 1e-12);
  const std::vector<Finding> findings = shared_bus_findings(driven.checked(), buses);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].rule, "battery-power");
  EXPECT_EQ(findings[0].severity, actuator::Severity::kViolation);
  EXPECT_NEAR(*findings[0].value, 561.0, 1e-9);
  EXPECT_NEAR(*findings[0].limit, 490.0, 1e-12);
  EXPECT_DOUBLE_EQ(*findings[0].time_s, 0.02);
  driven.robot.drivetrains[1].actuators[0].battery->series_cells = 2.0;
  EXPECT_TRUE(shared_buses(driven.checked(), torques_Nm).empty());
}

// Together they return 100 W, 1 A at most is taken back: 1 (50 + 0.1) W. What a drive alone may not
// return is its region's matter, and not counted here.
TEST(SharedBus, CountsTheSamplesWhoseReturnIsTooMuch) {
  DrivenMotion driven = on_one_battery(3);
  for (Drivetrain& drivetrain : driven.robot.drivetrains) {
    drivetrain.actuators[0].battery->charge_limit_A = 1.0;
    drivetrain.actuators[0].drive.regeneration_limit_W = 10.0;
  }
  for (std::size_t sample = 0; sample < 3; ++sample) {
    driven.demand.drives[0][sample].speed_rad_s = 4.0;
    driven.demand.drives[1][sample].speed_rad_s = 3.0;
  }
  Eigen::MatrixXd torques_Nm(2, 3);
  torques_Nm << 10.0, -60.0, -20.0,  //
      10.0, 20.0, 20.0;
  const std::vector<SharedBus> buses = shared_buses(driven.checked(), torques_Nm);
  ASSERT_EQ(buses.size(), 1u);
  EXPECT_EQ(buses[0].flooded, 1u);
  const std::vector<Finding> findings = shared_bus_findings(driven.checked(), buses);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].rule, "battery-power");
  EXPECT_EQ(findings[0].severity, actuator::Severity::kViolation);
  EXPECT_NEAR(*findings[0].value, power_W(-60.0, 4.0) + power_W(20.0, 3.0), 1e-9);
  EXPECT_NEAR(*findings[0].limit, -50.1, 1e-12);
  EXPECT_DOUBLE_EQ(*findings[0].time_s, 0.01);
}

// A stiff wall of 50 V behind 2 ohm delivers 312.5 W, at 25 V, and no more.
TEST(SharedBus, StandsAtHalfTheOpenCircuitWhereItGivesOut) {
  DrivenMotion driven = on_one_battery(2);
  for (Drivetrain& drivetrain : driven.robot.drivetrains) {
    drivetrain.actuators[0].battery->cell_resistance_ohm = 2.0;
  }
  for (std::size_t sample = 0; sample < 2; ++sample) {
    driven.demand.drives[0][sample].speed_rad_s = 4.0;
  }
  Eigen::MatrixXd torques_Nm = Eigen::MatrixXd::Zero(2, 2);
  torques_Nm(0, 1) = 60.0;  // 312 W
  EXPECT_EQ(shared_buses(driven.checked(), torques_Nm)[0].starved, 0u);
  torques_Nm(0, 1) = 60.2;  // 313.3 W
  const SharedBus bus = shared_buses(driven.checked(), torques_Nm)[0];
  EXPECT_EQ(bus.starved, 1u);
  EXPECT_DOUBLE_EQ(bus.voltage_V[1], 25.0);
  EXPECT_DOUBLE_EQ(bus.least_V, 25.0);
  const std::vector<Finding> findings = shared_bus_findings(driven.checked(), {bus});
  EXPECT_FALSE(findings[0].limit);  // the battery states none
}

// Oracle: a straight count. Without resistance 50 V give P/50 A, and 0.03 s of 500 W take 0.3 C of
// two cells of 0.01 Ah side by side, 72 C.
TEST(BatteryCharge, LastsForAsManyRunsAsTheCellsHold) {
  DrivenMotion driven = on_one_battery(4);
  for (Drivetrain& drivetrain : driven.robot.drivetrains) {
    actuator::Battery& battery = *drivetrain.actuators[0].battery;
    battery.cell_open_circuit = {{0.0, 50.0}, {1.0, 50.0}};
    battery.cell_resistance_ohm = 0.0;
    battery.cell_capacity_Ah = 0.01;
    battery.parallel_cells = 2.0;
  }
  const Eigen::MatrixXd torques_Nm = Eigen::MatrixXd::Constant(2, 4, 50.0);  // 50 W in each winding
  for (std::size_t sample = 0; sample < 4; ++sample) {
    driven.demand.drives[0][sample].speed_rad_s = driven.demand.drives[1][sample].speed_rad_s = 4.0;
  }
  const double run_Ah = 0.03 * 2.0 * power_W(50.0, 4.0) / 50.0 / 3600.0;
  driven.options.runs = 239;  // of 0.3 C
  std::vector<Finding> findings = battery_charge_findings(driven.checked(), torques_Nm);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].severity, actuator::Severity::kNote);
  EXPECT_NEAR(*findings[0].value, 239.0 * run_Ah, 1e-12);
  EXPECT_NEAR(*findings[0].limit, 0.02, 1e-15);
  driven.options.runs = 241;
  findings = battery_charge_findings(driven.checked(), torques_Nm);
  EXPECT_EQ(findings[0].severity, actuator::Severity::kViolation);
  driven.options.runs = 1;
  driven.options.conditions.state_of_charge = 0.5;
  EXPECT_NEAR(*battery_charge_findings(driven.checked(), torques_Nm)[0].limit, 0.01, 1e-15);
  EXPECT_TRUE(battery_charge_findings(driven.checked(), -torques_Nm).empty());  // it is charged
  for (Drivetrain& drivetrain : driven.robot.drivetrains) {
    drivetrain.actuators[0].battery->cell_capacity_Ah.reset();
  }
  EXPECT_TRUE(battery_charge_findings(driven.checked(), torques_Nm).empty());
}

/// Two drives over four samples: 4 Nm of their rotors' own beside 10 and -20 Nm of the load.
DrivenMotion with_rotors() {
  DrivenMotion driven(4);
  for (std::size_t drive = 0; drive < 2; ++drive) {
    for (DriveInstant& at : driven.demand.drives[drive]) {
      at.load_torque_Nm = drive == 0 ? 10.0 : -20.0;
      at.torque_Nm = at.load_torque_Nm + 4.0;
    }
  }
  driven.demand.forces_N.setZero(3, 4);
  return driven;
}

Eigen::MatrixXd rows_of(double one_Nm, double two_Nm) {
  Eigen::MatrixXd torques_Nm(2, 4);
  torques_Nm.row(0).setConstant(one_Nm);
  torques_Nm.row(1).setConstant(two_Nm);
  return torques_Nm;
}

// Torques that are nearer to those with the rotors' own hold them already. What one of eight is off
// is 1/sqrt(8) of it rms, beside the file's own 15.33 Nm rms: 2.1 Nm are 4.8 %, 2.2 Nm are 5.1 %.
TEST(DriveTorques, AreTheFilesWhereTheyHoldTheRotors) {
  for (const double off_Nm : {2.1, 2.2}) {
    DrivenMotion driven = with_rotors();
    driven.demand.file_torque_Nm = rows_of(14.0, -16.0);
    driven.demand.file_torque_Nm(1, 2) -= off_Nm;
    const DriveTorques torques = drive_torques(driven.checked());
    EXPECT_TRUE(torques.from_file);
    EXPECT_EQ(torques.inertia, actuator::InertiaConvention::kIncluded);
    EXPECT_EQ(torques.torque_Nm, driven.demand.file_torque_Nm);
    ASSERT_EQ(torques.findings.size(), 1u);
    const Finding& finding = torques.findings[0];
    EXPECT_EQ(finding.severity,
              off_Nm < 2.15 ? actuator::Severity::kNote : actuator::Severity::kWarning);
    EXPECT_DOUBLE_EQ(*finding.value, off_Nm);
    EXPECT_DOUBLE_EQ(*finding.time_s, 0.02);
    EXPECT_NE(finding.sentence.find(off_Nm < 2.15 ? "by 0.742 Nm rms" : "by 0.778 Nm rms"),
              std::string::npos)
        << finding.sentence;
  }
}

// Torques of the load get the rotors' own added.
TEST(DriveTorques, GetTheRotorsWhereTheFileLeavesThemOut) {
  DrivenMotion driven = with_rotors();
  driven.demand.file_torque_Nm = rows_of(10.0, -20.0);
  driven.demand.file_torque_Nm(0, 1) += 0.5;
  const DriveTorques torques = drive_torques(driven.checked());
  EXPECT_TRUE(torques.from_file);
  EXPECT_EQ(torques.inertia, actuator::InertiaConvention::kIncluded);  // as they now are
  EXPECT_DOUBLE_EQ(torques.torque_Nm(0, 0), 14.0);
  EXPECT_DOUBLE_EQ(torques.torque_Nm(0, 1), 14.5);
  EXPECT_DOUBLE_EQ(torques.torque_Nm(1, 3), -16.0);
  EXPECT_DOUBLE_EQ(*torques.findings[0].value, 0.5);
  EXPECT_DOUBLE_EQ(*torques.findings[0].time_s, 0.01);
  EXPECT_NE(torques.findings[0].sentence.find("without the rotors'"), std::string::npos);
  EXPECT_EQ(torques.findings[0].severity, actuator::Severity::kNote);
}

// A column that is dead or of the other sign is no nearer to the dynamics than no torque is; one of
// half the size is.
TEST(DriveTorques, AreDoubtfulWhereTheFilesExplainNothing) {
  for (const double factor : {0.0, -1.0, 0.5}) {
    DrivenMotion driven = with_rotors();
    driven.demand.file_torque_Nm = factor * rows_of(14.0, -16.0);
    EXPECT_EQ(drive_torques(driven.checked()).is_doubtful, factor <= 0.0) << factor;
    driven.options.torques = TorqueSource::kFile;
    EXPECT_FALSE(drive_torques(driven.checked()).is_doubtful);
  }
}

TEST(DriveTorques, AreThoseThatWereAskedFor) {
  DrivenMotion driven = with_rotors();
  EXPECT_EQ(drive_torques(driven.checked()).torque_Nm, rows_of(14.0, -16.0));
  driven.options.torques = TorqueSource::kFile;
  EXPECT_THROW(drive_torques(driven.checked()), io::SpecError);
  driven.demand.file_torque_Nm = rows_of(1.0, 2.0);
  EXPECT_EQ(drive_torques(driven.checked()).torque_Nm, rows_of(1.0, 2.0));
  driven.options.torques = TorqueSource::kDynamics;
  EXPECT_EQ(drive_torques(driven.checked()).torque_Nm, rows_of(14.0, -16.0));
  driven.demand.has_dynamics = false;  // then the file's are all there is
  const DriveTorques torques = drive_torques(driven.checked());
  EXPECT_EQ(torques.torque_Nm, rows_of(1.0, 2.0));
  EXPECT_EQ(torques.inertia, actuator::InertiaConvention::kUnstated);
  EXPECT_TRUE(torques.findings.empty());
}

// From the first sample to the last, each on its own drive.
TEST(DriveReports, CountEverySampleOfTheirDrive) {
  DrivenMotion driven = with_rotors();
  DriveTorques torques = drive_torques(driven.checked());
  torques.torque_Nm << 60.0, 1.0, 1.0, 1.0,  //
      1.0, 1.0, 1.0, -70.0;
  const DriveReports reports = check_drives(driven.checked(), torques, {});
  ASSERT_EQ(reports.drives.size(), 2u);
  EXPECT_EQ(reports.drives[0].samples, 4u);
  EXPECT_DOUBLE_EQ(reports.drives[0].from_s, 0.0);
  EXPECT_DOUBLE_EQ(reports.drives[0].until_s, 0.03);
  EXPECT_DOUBLE_EQ(reports.drives[0].interpretation.peak_torque_Nm, 60.0);
  EXPECT_DOUBLE_EQ(reports.drives[1].interpretation.peak_torque_Nm, 70.0);
  const DriveReports second = check_drivetrain(driven.checked(), torques, {}, 1);
  ASSERT_EQ(second.drives.size(), 1u);
  EXPECT_EQ(second.drives[0].name, "two");
  EXPECT_DOUBLE_EQ(second.drives[0].interpretation.peak_torque_Nm, 70.0);
}

// Oracle: closed form, as of Check.HoldsAWarmWindingAgainstItsOwnRegion: 10 Nm settle at 27.8 K,
// where the drive of 43 rad/s does 42.44.
TEST(DriveReports, HoldRepeatedRunsAgainstTheHeatOfTheLast) {
  DrivenMotion driven(4);
  for (Drivetrain& drivetrain : driven.robot.drivetrains) {
    actuator::Actuator& actuator = drivetrain.actuators[0];
    actuator = test::simple_actuator();
    actuator.thermal = actuator::Thermal{0.2, 0.3, 20.0, 200.0, 380.0, 300.0};
    actuator.motor.winding_temperature_K = 300.0;
    actuator.effects.push_back(
        {actuator::find_effect("winding_resistance_temperature"), {0.004}, {}, false, ""});
  }
  for (DriveInstant& instant : driven.demand.drives[0]) instant.speed_rad_s = 42.7;
  DriveTorques torques = drive_torques(driven.checked());
  torques.torque_Nm.row(0).setConstant(10.0);
  EXPECT_EQ(check_drives(driven.checked(), torques, {}).drives[0].verdict,
            actuator::Verdict::kPass);
  driven.options.runs = 10'000'000;
  const DriveReports warm = check_drives(driven.checked(), torques, {});
  EXPECT_EQ(warm.drives[0].verdict, actuator::Verdict::kFail);
  EXPECT_NEAR(*warm.drives[0].held_heat->shown_K, 300.0 + 25.0 / 0.9, 1e-3);
  EXPECT_EQ(warm.drives[1].verdict, actuator::Verdict::kPass);
  driven.options.conditions.winding_temperature_K = 300.0;
  EXPECT_EQ(check_drives(driven.checked(), torques, {}).drives[0].verdict,
            actuator::Verdict::kPass);
}

// Oracle: means by hand over windows of 20 ms. Limits: a tenth of 100 N, and that times 0.5 m.
TEST(BaseResidual, IsTheGreatestMeanOverItsWindowAndTheShareBeyond) {
  DrivenMotion driven(11);
  driven.options.residual_window_s = 0.02;
  driven.demand.residual.row(0).segment(4, 3).setConstant(12.0);  // 3-4-5 with the next
  driven.demand.residual.row(1).segment(4, 3).setConstant(16.0);
  driven.demand.residual(2, 8) = -8.0;  // one sample: a triangle, 4 Nm over the window
  driven.demand.residual.row(3).setConstant(6.0);
  const BaseResidual found = base_residual(driven.checked());
  EXPECT_NEAR(found.force.mean, 20.0, 1e-12);
  EXPECT_DOUBLE_EQ(found.force.time_s, 0.04);
  EXPECT_DOUBLE_EQ(found.force.limit, 10.0);
  // Windows from 30 and 50 ms mean 15 N, those from 20 and 60 ms 5 N: three of eleven are beyond.
  EXPECT_NEAR(found.force.share_beyond, 3.0 / 11.0, 1e-15);
  EXPECT_NEAR(found.moment.mean, 4.0, 1e-12);
  EXPECT_DOUBLE_EQ(found.moment.limit, 5.0);
  EXPECT_EQ(found.moment.share_beyond, 0.0);
  EXPECT_NEAR(found.passive.mean, 6.0, 1e-12);
  EXPECT_NEAR(found.passive.share_beyond, 9.0 / 11.0, 1e-15);  // windows that end in the motion
  EXPECT_THROW(require_physical(driven.checked(), found, {}), io::SpecError);
}

// By hand: two forces and a moment of the base, then a hinge's torque and a slide's force.
TEST(FreeRows, TellTheForceOfASlideFromATorque) {
  Robot robot;
  robot.tree.base = dynamics::BaseKind::kPlanar;
  robot.tree.bodies.resize(3);
  robot.tree.bodies[2].joint.kind = dynamics::JointKind::kPrismatic;
  const WholeBody body(robot);
  const FreeRows rows(body);
  EXPECT_EQ(rows.kinds().slides, std::vector<Index>{4});
  const Eigen::VectorXd scales = rows.scales(100.0, 0.5);
  EXPECT_EQ(scales, (Eigen::VectorXd(5) << 100.0, 100.0, 50.0, 50.0, 100.0).finished());
}

// Oracle: 6 N along a slide are 3 Nm at the size of 0.5 m, of noise alike.
TEST(BaseResidual, TakesTheForceOfASlideAtTheRobotsSize) {
  DrivenMotion driven(11);
  driven.demand.rows.slides = {3};
  driven.demand.residual.row(3).setConstant(6.0);
  EXPECT_NEAR(base_residual(driven.checked()).passive.mean, 3.0, 1e-12);
  EXPECT_NEAR(base_residual(driven.checked()).passive.limit, 5.0, 1e-12);
  driven.demand.residual_noise.setZero(4);
  driven.demand.residual_noise[3] = 1.0;
  EXPECT_NEAR(base_residual(driven.checked()).passive.limit, 5.0 + 4.0 * 0.5, 1e-12);
}

TEST(BaseResidual, CountsTheImpulsesOfJolts) {
  DrivenMotion driven(11);
  driven.options.residual_window_s = 0.02;
  Jolt jolt;
  jolt.sample = 5;
  jolt.residual = Eigen::Vector4d(0.0, 0.19, 0.0, 0.0);
  driven.demand.jolts = {jolt};
  BaseResidual found = base_residual(driven.checked());
  EXPECT_NEAR(found.force.mean, 9.5, 1e-12);  // 0.19 N s in 20 ms
  EXPECT_NO_THROW(require_physical(driven.checked(), found, {}));
  driven.demand.jolts[0].residual[1] = 0.21;
  found = base_residual(driven.checked());
  EXPECT_THROW(require_physical(driven.checked(), found, {}), io::SpecError);
}

}  // namespace
}  // namespace torquewright::hopper
