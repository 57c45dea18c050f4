// SPDX-License-Identifier: Apache-2.0
// Which row accelerations belong to. Oracle: velocities that are summed from them, by the rule of
// an integrator of first or second order, from their own row on or from the row before.
#include "hopper/check/late_columns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hopper/check/hopper_check.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/mechanisms/constant_jacobian.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Verdict;
using Eigen::Index;

constexpr double kStep_s = 1e-3;
constexpr Index kPeriod = 10;  // rows

/// A balanced arm on a hinge and its drive: at `bus_V` a line between speed and torque.
Robot driven_arm(double bus_V) {
  Robot robot;
  robot.tree.gravity_m_s2 = 0.0;
  dynamics::Body body;
  body.joint.name = "hinge";
  body.inertia = {1.0, Eigen::Vector3d::Zero(), 0.2 * Eigen::Matrix3d::Identity()};
  robot.tree.bodies = {dynamics::Body{}, body};
  Drivetrain drivetrain;
  drivetrain.mechanism = std::make_shared<ConstantJacobian>(direct_drive());
  drivetrain.joints = {1};
  actuator::Actuator actuator;
  actuator.motor.torque_constant_Nm_A = 20.0;
  actuator.motor.resistance_ohm = 8.0;
  actuator.drive = {.bus_voltage_V = bus_V, .peak_current_A = 1000, .continuous_current_A = {}};
  actuator.transmission.ratio = 1.0;
  drivetrain.actuators = {actuator};
  drivetrain.actuator_names = {"drive"};
  drivetrain.actuator_files = {"drive.json"};
  robot.drivetrains = {drivetrain};
  return robot;
}

/// The weights of an acceleration's own row, the next and the one after in a step of the velocity.
using StepRule = std::array<double, 3>;
constexpr StepRule kFirstOrder{1.0, 0.0, 0.0};
constexpr StepRule kSecondOrder{0.5, 0.5, 0.0};
constexpr StepRule kFirstOrderLate{0.0, 1.0, 0.0};
constexpr StepRule kSecondOrderLate{0.0, 0.5, 0.5};
constexpr StepRule kBetween{0.25, 0.75, 0.0};  // as far from either

Motion swing(const StepRule& rule, Index samples = 200) {
  Motion motion;
  const auto rate_rad_s2 = [](Index i) {
    return 4000.0 * std::sin(2.0 * std::numbers::pi * static_cast<double>(i) / kPeriod);
  };
  motion.positions.setZero(1, samples);
  motion.velocities.setZero(1, samples);
  motion.accelerations.setZero(1, samples);
  motion.efforts.setZero(1, samples);
  motion.has_effort = {false};
  motion.file = "swing.csv";
  motion.velocities(0, 0) = -6.0;
  for (Index i = 0; i < samples; ++i) {
    motion.times_s.push_back(kStep_s * static_cast<double>(i));
    motion.accelerations(0, i) = rate_rad_s2(i);
    if (i + 1 == samples) break;
    motion.velocities(0, i + 1) = motion.velocities(0, i);
    for (Index later = 0; later < 3; ++later) {
      motion.velocities(0, i + 1) +=
          kStep_s * rule[static_cast<std::size_t>(later)] * rate_rad_s2(i + later);
    }
    motion.positions(0, i + 1) =
        motion.positions(0, i) + 0.5 * kStep_s * motion.velocities.row(0).segment(i, 2).sum();
  }
  return motion;
}

RowReading reading_of(Motion& motion, LateRows rows = LateRows::kFind) {
  CheckOptions options;
  options.late_columns = rows;
  return {driven_arm(100.0), options, motion};
}

TEST(LateColumns, OfAccelerationsAreToldByTheVelocities) {
  for (const StepRule& rule : {kFirstOrder, kSecondOrder, kFirstOrderLate, kSecondOrderLate}) {
    SCOPED_TRACE(testing::PrintToString(rule));
    const bool is_late = rule[0] == 0.0;
    const Motion file = swing(rule);
    Motion motion = file;
    const RowReading reading = reading_of(motion);
    EXPECT_EQ(reading.late().accelerations, is_late);
    EXPECT_FALSE(reading.open().any());
    EXPECT_EQ(reading.findings().size(), is_late ? 1u : 0u);
    ASSERT_EQ(motion.samples(), file.samples() - (is_late ? 1 : 0));
    const Index rows = motion.samples();
    EXPECT_EQ(motion.accelerations, is_late ? file.accelerations.rightCols(rows).eval()
                                            : file.accelerations.leftCols(rows).eval());
    EXPECT_EQ(motion.velocities, file.velocities.leftCols(rows));
  }
}

TEST(LateColumns, AreLeftAloneWhereNothingChangesOrRowsAreFew) {
  Motion steady = swing(kFirstOrderLate);
  steady.accelerations.setZero();
  steady.velocities.setConstant(1.0);
  EXPECT_FALSE(reading_of(steady).open().any());
  Motion brief = swing(kFirstOrderLate, 9);
  EXPECT_FALSE(reading_of(brief).late().any());
  // Rows of one time state an impact: no log of steps.
  Motion impact = swing(kFirstOrderLate);
  impact.times_s[101] = impact.times_s[100];
  impact.breaks = {101};
  EXPECT_FALSE(reading_of(impact).late().any());
  EXPECT_THROW(reading_of(impact, LateRows::kShift), io::SpecError);
}

TEST(LateColumns, AreReadAsStated) {
  Motion kept = swing(kFirstOrderLate);
  EXPECT_FALSE(reading_of(kept, LateRows::kKeep).late().any());
  Motion moved = swing(kFirstOrder);
  EXPECT_TRUE(reading_of(moved, LateRows::kShift).late().accelerations);
  EXPECT_EQ(moved.samples(), 199);
}

// "shift" of a file that has nothing to shift would be dropped in silence.
TEST(LateColumns, ThatAreNotThereCannotBeShifted) {
  Motion bare = swing(kFirstOrder);
  bare.acceleration_origin = Origin::kAbsent;
  try {
    reading_of(bare, LateRows::kShift);
    FAIL() << "was read";
  } catch (const io::SpecError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("--late-columns shift: there is nothing to shift"), std::string::npos)
        << said;
  }
  EXPECT_FALSE(reading_of(bare, LateRows::kKeep).late().any());
}

Verdict verdict_of(double bus_V, const StepRule& rule, LateRows rows, bool* is_said = nullptr) {
  CheckOptions options;
  options.late_columns = rows;
  Motion motion = swing(rule);
  const HopperReport report = check_motion(driven_arm(bus_V), motion, options);
  for (const Finding& finding : report.check.findings) {
    const bool is_warning =
        finding.rule == "late-columns" && finding.severity == actuator::Severity::kWarning;
    if (is_said != nullptr) *is_said = *is_said || is_warning;
  }
  return report.check.verdict;
}

// What nothing decides leaves the verdict open where it turns on it, and only there.
TEST(LateColumns, LeaveTheVerdictOpenWhereItTurnsOnThem) {
  int turns = 0;
  for (double bus_V = 200.0; bus_V < 4000.0; bus_V *= 1.05) {
    SCOPED_TRACE(bus_V);
    const Verdict kept = verdict_of(bus_V, kBetween, LateRows::kKeep);
    const Verdict moved = verdict_of(bus_V, kBetween, LateRows::kShift);
    bool is_said = false;
    const Verdict found = verdict_of(bus_V, kBetween, LateRows::kFind, &is_said);
    EXPECT_EQ(found, kept == moved ? kept : Verdict::kUndecided);
    EXPECT_EQ(is_said, kept != moved);
    if (kept != moved) ++turns;
  }
  EXPECT_GT(turns, 0);  // else this says nothing
}

}  // namespace
}  // namespace torquewright::hopper
