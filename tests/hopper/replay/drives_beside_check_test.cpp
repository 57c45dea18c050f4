// SPDX-License-Identifier: Apache-2.0
// The hand-made flip's torques, through the drives of a simulation.
// Oracle: `hopper check`, which holds the same torques against regions of its own at voltages of
// its own, and the region of actuator/region itself.
#include <gtest/gtest.h>

#include <cmath>

#include "actuator/conditions/held_region.hpp"
#include "actuator/region/joint_region.hpp"
#include "hopper/check/hopper_check.hpp"
#include "hopper/motion/motion_reader.hpp"
#include "hopper/replay/powered_drives.hpp"
#include "robot/model/robot_spec.hpp"
#include "tests/actuator/example_actuator.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kKneePeak_Nm = 320.0;
/// The drives of the flip have no losses: their tables are exact, but for rounding.
constexpr double kRounding_Nm = 1e-9 * kKneePeak_Nm;
/// To which the voltage is solved for, 1e-7 of 67.2 V, of the knee's 23 Nm/V.
constexpr double kVoltage_Nm = 1e-7 * 67.2 * 23.0;

struct CheckedFlip {
  Robot robot;
  HopperReport report;
  MatrixXd cut_off_Nm, bus_V, power_W;

  explicit CheckedFlip(double battery_ohm_factor, const std::vector<double>& lines_ohm = {}) {
    const std::string specs = TORQUEWRIGHT_SOURCE_DIR "/specs/";
    robot = read_robot(specs + "robot/hopper.json").robot;
    for (Drivetrain& drivetrain : robot.drivetrains) {
      for (actuator::Actuator& actuator : drivetrain.actuators) {
        actuator.battery->cell_resistance_ohm *= battery_ohm_factor;
      }
    }
    for (std::size_t i = 0; i < lines_ohm.size(); ++i) {
      Drivetrain& drivetrain = robot.drivetrains[i == 0 ? 0 : 1];
      drivetrain.actuators[i == 0 ? 0 : i - 1].effects.push_back(
          actuator::effect("voltage_sag", {lines_ohm[i]}));
    }
    Motion motion = read_motion(robot, {specs + "trajectory/hopper_flip.csv", {}, {}, {}});
    report = check_motion(robot, motion, {});
    PoweredDrives drives(robot, {});
    const MatrixXd& wanted_Nm = report.torques_Nm;
    cut_off_Nm.resizeLike(wanted_Nm);
    bus_V.resizeLike(wanted_Nm);
    power_W.resize(1, wanted_Nm.cols());
    for (Index sample = 0; sample < wanted_Nm.cols(); ++sample) {
      const DriveStep& step =
          drives.drive(wanted_Nm.col(sample), Eigen::VectorXd::Zero(wanted_Nm.rows()),
                       speeds_rad_s(sample), 1e-3);
      cut_off_Nm.col(sample) = step.cut_off_Nm;
      bus_V.col(sample) = step.bus_V;
      power_W(sample) = step.power_W;
    }
  }

  double speed_rad_s(Index drive, Index sample) const {
    return report.demand.drives[static_cast<std::size_t>(drive)][static_cast<std::size_t>(sample)]
        .speed_rad_s;
  }
  Eigen::VectorXd speeds_rad_s(Index sample) const {
    Eigen::VectorXd speeds(report.torques_Nm.rows());
    for (Index i = 0; i < speeds.size(); ++i) speeds[i] = speed_rad_s(i, sample);
    return speeds;
  }
  const actuator::Actuator& actuator(Index drive) const {
    return drive == 0 ? robot.drivetrains[0].actuators[0]
                      : robot.drivetrains[1].actuators[static_cast<std::size_t>(drive - 1)];
  }
  std::size_t clipped(Index drive) const {
    return static_cast<std::size_t>((cut_off_Nm.row(drive).array() != 0.0).count());
  }
  /// Of the region on a bus that is held there. Past the overspeed, where that is empty and the
  /// check calls all of the torque too much, the greatest braking torque acts, as clip.hpp has it.
  double excess_Nm(Index drive, Index sample, double held_V) const {
    actuator::Actuator held = actuator(drive);
    held.battery.reset();
    held.drive.bus_voltage_V = held_V;
    const actuator::JointRange range = range_at(held, {}, speed_rad_s(drive, sample));
    const double wanted_Nm = report.torques_Nm(drive, sample);
    if (range.is_empty) {
      return std::abs(wanted_Nm + std::copysign(kKneePeak_Nm, speed_rad_s(drive, sample)));
    }
    return std::max({0.0, wanted_Nm - range.greatest.torque_Nm, range.least.torque_Nm - wanted_Nm});
  }
};

// Without a sag there is one voltage, and every sample is cut by what the check finds too much.
TEST(DrivesBesideCheck, CutOffOnAStiffBatteryWhatTheCheckFindsTooMuch) {
  const CheckedFlip flip(0.0);
  for (Index drive = 0; drive < 3; ++drive) {
    for (Index sample = 0; sample < flip.cut_off_Nm.cols(); ++sample) {
      EXPECT_NEAR(std::abs(flip.cut_off_Nm(drive, sample)), flip.excess_Nm(drive, sample, 67.2),
                  kRounding_Nm)
          << drive << " " << sample;
      EXPECT_EQ(flip.bus_V(drive, sample), 67.2);
    }
    const auto& found = flip.report.check.drives[static_cast<std::size_t>(drive)].interpretation;
    EXPECT_EQ(flip.clipped(drive), found.clipped_samples);
    if (found.worst.limit_Nm) {
      EXPECT_NEAR(flip.cut_off_Nm.row(drive).cwiseAbs().maxCoeff(), found.worst.excess_Nm,
                  kRounding_Nm);
    }
  }
  EXPECT_GT(flip.clipped(0), 10u);
}

// Where nothing is cut, power and voltage are the check's. Where something is, the torques that
// then act leave another voltage than those that were asked for: there the region at that voltage
// says how much.
TEST(DrivesBesideCheck, SagAsTheCheckDoes) {
  const CheckedFlip flip(1.0);
  const SharedBus& bus = flip.report.buses.at(0);
  double least_V = bus.open_circuit_V;
  Index agreed = 0;
  for (Index sample = 0; sample < flip.cut_off_Nm.cols(); ++sample) {
    if ((flip.cut_off_Nm.col(sample).array() == 0.0).all()) {
      EXPECT_NEAR(flip.bus_V(0, sample), bus.voltage_V[sample], 1e-9) << sample;
      least_V = std::min(least_V, flip.bus_V(0, sample));
      ++agreed;
      continue;
    }
    for (Index drive = 0; drive < 3; ++drive) {
      const double held_V = flip.bus_V(drive, sample);
      EXPECT_NEAR(std::abs(flip.cut_off_Nm(drive, sample)), flip.excess_Nm(drive, sample, held_V),
                  kVoltage_Nm)
          << drive << " " << sample;
    }
  }
  EXPECT_GT(agreed, 900);
  EXPECT_GT(least_V, bus.least_V);
  EXPECT_LT(least_V, bus.open_circuit_V - 2.0);  // it did sag
  // The check's voltage is that under all of the torque: it may clip a sample more.
  const std::size_t found = flip.report.check.drives[0].interpretation.clipped_samples;
  EXPECT_LE(flip.clipped(0), found);
  EXPECT_GE(flip.clipped(0) + 2, found);
  EXPECT_EQ(flip.clipped(1) + flip.clipped(2), 0u);
}

// Each drive behind cables of its own (voltage_sag), all on one battery: one voltage at the battery
// in both, under what flows out of it, cables' losses among that: P = V (Voc - V) / R. What is cut
// is what the region with the drive's own cables leaves at that voltage.
TEST(DrivesBesideCheck, SagBehindTheirOwnCablesAsTheCheckDoes) {
  const CheckedFlip flip(1.0, {0.03, 0.01, 0.0});
  const SharedBus& bus = flip.report.buses.at(0);
  constexpr double kBattery_ohm = 16 * 0.015 / 4;
  const double table_Nm =
      actuator::HeldRegion(flip.actuator(0), {}, actuator::GridTemperatures::kAsAsked).error_Nm();
  Index agreed = 0;
  for (Index sample = 0; sample < flip.cut_off_Nm.cols(); ++sample) {
    const double V = flip.bus_V(0, sample);
    EXPECT_NEAR(flip.power_W(sample), V * (bus.open_circuit_V - V) / kBattery_ohm, 1e-2);
    if ((flip.cut_off_Nm.col(sample).array() == 0.0).all()) {
      EXPECT_NEAR(V, bus.voltage_V[sample], 1e-7 * bus.open_circuit_V) << sample;
      ++agreed;
      continue;
    }
    EXPECT_NEAR(std::abs(flip.cut_off_Nm(0, sample)), flip.excess_Nm(0, sample, V),
                kVoltage_Nm + table_Nm)
        << sample;
  }
  EXPECT_GT(agreed, 900);
  EXPECT_LT(bus.least_V, bus.open_circuit_V - 2.0);
  EXPECT_GT(flip.clipped(0), 10u);
}

}  // namespace
}  // namespace torquewright::hopper
