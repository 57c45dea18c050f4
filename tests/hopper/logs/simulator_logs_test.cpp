// SPDX-License-Identifier: Apache-2.0
// Oracle: MuJoCo's own torques, forces and momentum at its fine step. The robots are public ones,
// read from ../shared/data; skipped where they are absent.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "io/faults/spec_error.hpp"
#include "tests/hopper/logs/hop_log.hpp"

namespace torquewright::test {
namespace {

using actuator::Verdict;

/// A robot and its hop, simulated once for all tests.
struct Hop {
  PublicHopper hopper;
  SimulatedHop hop;
};

const Hop* hop_of(const std::string& name) {
  static std::map<std::string, Hop> known;
  if (const auto at = known.find(name); at != known.end()) return &at->second;
  auto hopper = read_public_hopper(name);
  if (!hopper) return nullptr;
  SimulatedHop hop = simulate_hop(*hopper);
  return &known.emplace(name, Hop{std::move(*hopper), std::move(hop)}).first->second;
}

struct Checked {
  hopper::HopperReport report;
  HopErrors errors;
  Eigen::Index reach;
};

Checked check(const Hop& it, const LogContent& content, const hopper::CheckOptions& options = {}) {
  hopper::Motion log = log_of(it.hopper, it.hop, content);
  hopper::HopperReport report = hopper::check_motion(it.hopper.robot, log, options);
  const HopErrors errors = errors_of(it.hop, log, report);
  return {std::move(report), errors, log.reach};
}

bool has(const hopper::HopperReport& report, const char* rule) {
  const auto& findings = report.check.findings;
  return std::any_of(findings.begin(), findings.end(),
                     [rule](const hopper::Finding& finding) { return finding.rule == rule; });
}

void expect_goals(const HopErrors& errors) {
  EXPECT_LE(errors.peak, kTorqueGoal);
  EXPECT_LE(errors.rms, kTorqueGoal);
  EXPECT_LE(errors.flight_momentum, kMomentumGoal);
  EXPECT_LE(errors.impulse, kImpulseGoal);
}

TEST(SimulatorLogs, OfOneLegNeedPositionsAlone) {
  const Hop* it = hop_of("hopper");
  if (it == nullptr) GTEST_SKIP() << "needs the public robots, ../shared/data";
  for (const bool velocities : {false, true}) {
    for (const bool flags : {false, true}) {
      const Checked found = check(*it, {1000, velocities, false, false, flags, 0.0});
      SCOPED_TRACE(velocities ? "velocities" : "positions");
      expect_goals(found.errors);
      EXPECT_EQ(found.reach, 1);  // no noise, no smoothing
      EXPECT_EQ(has(found.report, "contacts-searched"), !flags);
    }
  }
}

TEST(SimulatorLogs, WithSensorNoiseAreSmoothedAndNoMore) {
  const Hop* it = hop_of("hopper");
  if (it == nullptr) GTEST_SKIP() << "needs the public robots, ../shared/data";
  const Checked found = check(*it, {1000, true, false, false, true, 1.0});
  expect_goals(found.errors);
  EXPECT_GT(found.reach, 1);
}

TEST(SimulatorLogs, WithForcesTellHowFeetShare) {
  const Hop* it = hop_of("go1");
  if (it == nullptr) GTEST_SKIP() << "needs the public robots, ../shared/data";
  expect_goals(check(*it, {1000, true, false, true, false, 0.0}).errors);
}

// Another share among the feet is warned of; another weight on all of them is another robot's.
TEST(SimulatorLogs, WithForcesOfAnotherMotionAreWarnedOf) {
  const Hop* it = hop_of("go1");
  if (it == nullptr) GTEST_SKIP() << "needs the public robots, ../shared/data";
  hopper::Motion whole = log_of(it->hopper, it->hop, {1000, true, false, true, false, 0.0});
  for (const double more : {0.0, 0.3}) {
    hopper::Motion log = whole;
    for (Eigen::Index row = 0; row < log.forces_N.rows(); ++row) {
      log.forces_N.row(row) *= row / 3 % 2 == 0 ? 1.0 + more : 1.0 - more;
    }
    const hopper::HopperReport report = hopper::check_motion(it->hopper.robot, log, {});
    const auto& findings = report.check.findings;
    const auto solved = std::find_if(
        findings.begin(), findings.end(),
        [](const hopper::Finding& finding) { return finding.rule == "contact-forces-solved"; });
    ASSERT_NE(solved, findings.end());
    EXPECT_EQ(solved->severity == actuator::Severity::kWarning, more != 0.0) << solved->sentence;
  }
  whole.forces_N *= 0.8;
  EXPECT_THROW(hopper::check_motion(it->hopper.robot, whole, {}), io::SpecError);
}

TEST(SimulatorLogs, WithoutForcesSayThatFeetMayShareOtherwise) {
  const Hop* it = hop_of("go1");
  if (it == nullptr) GTEST_SKIP() << "needs the public robots, ../shared/data";
  const Checked found = check(*it, {1000, true, false, false, false, 0.0});
  EXPECT_GT(found.errors.peak, kTorqueGoal);  // else this says nothing
  EXPECT_TRUE(found.errors.is_known);
  EXPECT_TRUE(has(found.report, "torque-doubt"));
  EXPECT_LE(found.errors.flight_momentum, kMomentumGoal);
  EXPECT_LE(found.errors.impulse, kImpulseGoal);
}

TEST(SimulatorLogs, AreUndecidedWhereTheLimitLiesInTheDoubt) {
  const Hop* known = hop_of("hopper");
  if (known == nullptr) GTEST_SKIP() << "needs the public robots, ../shared/data";
  Hop it = *known;
  const LogContent coarse{200, true, false, false, false, 0.0};
  const Checked first = check(it, coarse);
  const auto knee = static_cast<std::size_t>(it.hopper.robot.find_joint("knee").value() - 1);
  const hopper::PeakDoubt& doubt = first.report.peak_doubts[knee];
  ASSERT_GT(doubt.most_Nm, doubt.peak_Nm);
  ASSERT_LT(doubt.least_Nm, doubt.peak_Nm);
  const double limit_Nm = doubt.peak_Nm + first.report.check.drives[knee].interpretation.margin_Nm;
  actuator::Drive& drive = it.hopper.robot.drivetrains[knee].actuators[0].drive;
  const double current_A = drive.peak_current_A;
  const auto verdict_with = [&](double torque_Nm) {
    drive.peak_current_A = current_A * torque_Nm / limit_Nm;
    return check(it, coarse).report.check.drives[knee].verdict;
  };
  constexpr double kBeside = 1e-3;
  EXPECT_EQ(verdict_with(doubt.most_Nm * (1.0 + kBeside)), Verdict::kPass);
  EXPECT_EQ(verdict_with(doubt.most_Nm * (1.0 - kBeside)), Verdict::kUndecided);
  EXPECT_EQ(verdict_with(doubt.least_Nm * (1.0 + kBeside)), Verdict::kUndecided);
  EXPECT_EQ(verdict_with(doubt.least_Nm * (1.0 - kBeside)), Verdict::kFail);
}

// Feet as balls: the contact rolls over them as the shank turns. As points that are fixed to it the
// same feet leave a moment that nothing explains.
TEST(SimulatorLogs, OfFeetThatRollAreReadAsSuch) {
  const Hop* it = hop_of("go1_balls");
  if (it == nullptr) GTEST_SKIP() << "needs the public robots, ../shared/data";
  ASSERT_EQ(it->hopper.robot.contacts.size(), 4u);
  const LogContent content{1000, true, true, true, false, 0.0};
  const Checked found = check(*it, content);
  expect_goals(found.errors);
  Hop fixed = *it;
  for (hopper::ContactPoint& contact : fixed.hopper.robot.contacts) {
    contact.point.p_B_m.z() -= contact.radius_m;  // the sole of a shank that stands upright
    contact.radius_m = 0.0;
  }
  EXPECT_THROW(check(fixed, content), io::SpecError);
}

// With the file's own damping and dry friction, whose accelerations turn within a row.
TEST(SimulatorLogs, OfJointsThatRubAreNoWrongRates) {
  for (const char* name : {"go1", "go1_balls"}) {
    auto hopper = read_public_hopper(name, true);
    if (!hopper) GTEST_SKIP() << "needs the public robots, ../shared/data";
    SimulatedHop hop = simulate_hop(*hopper);
    const Hop it{std::move(*hopper), std::move(hop)};
    for (const bool forces : {false, true}) {
      for (const bool late : {false, true}) {
        EXPECT_NO_THROW(check(it, {200, true, true, forces, !forces, 0.0, late}))
            << name << (forces ? ", forces" : ", flags") << (late ? ", late" : "");
      }
    }
  }
}

// The simulator's own forces say when the last point lets go.
TEST(SimulatorLogs, TellTakeOffWithoutForces) {
  const Hop* it = hop_of("hopper");
  if (it == nullptr) GTEST_SKIP() << "needs the public robots, ../shared/data";
  const hopper::Motion& truth = it->hop.motion;
  const Checked found = check(*it, {1000, true, false, false, false, 0.0});
  ASSERT_FALSE(found.report.flights.empty());
  for (const hopper::Flight& flight : found.report.flights) {
    if (flight.until_s - flight.from_s < 0.1) continue;
    auto sample = static_cast<Eigen::Index>(std::lround(flight.until_s / it->hop.step_s)) - 40;
    while (sample > 0 && truth.forces_N.col(sample).isZero(0.0)) --sample;
    const double let_go_s = truth.time_s(sample);
    EXPECT_NEAR(flight.from_s, let_go_s, 2.5e-3);  // two rows, and half of one
  }
}

bool is_moved(const hopper::HopperReport& report, const char* what) {
  const auto& findings = report.check.findings;
  return std::any_of(findings.begin(), findings.end(), [what](const hopper::Finding& finding) {
    return finding.rule == "late-columns" && finding.severity == actuator::Severity::kNote &&
           finding.sentence.find(what) < finding.sentence.find(" belong to the row before");
  });
}

// Oracle: what the simulator computed a row before is what it computed: moved back, nothing is
// lost but the last row.
TEST(SimulatorLogs, WithWhatWasComputedARowBeforeAreReadSo) {
  const Hop* it = hop_of("go1");
  if (it == nullptr) GTEST_SKIP() << "needs the public robots, ../shared/data";
  for (const int rate_Hz : {200, 1000}) {
    for (const bool late : {false, true}) {
      SCOPED_TRACE(late ? "late" : "in time");
      LogContent content{rate_Hz, true, true, true, false, 0.0, late, true};
      const Checked found = check(*it, content);
      for (const char* what : {"accelerations", "contact forces", "torques"}) {
        EXPECT_EQ(is_moved(found.report, what), late) << what;
      }
      EXPECT_LE(found.errors.peak, kTorqueGoal);
      EXPECT_LE(found.errors.flight_momentum, kMomentumGoal);
      content.torques = false;  // those of the dynamics count, then
      expect_goals(check(*it, content).errors);
      hopper::CheckOptions keep;
      keep.late_columns = hopper::LateRows::kKeep;
      EXPECT_FALSE(has(check(*it, content, keep).report, "late-columns"));
    }
  }
}

// Each by its own physics: forces may be late where accelerations are not, and the other way round.
TEST(SimulatorLogs, MayHaveOneColumnARowLate) {
  const Hop* it = hop_of("go1");
  if (it == nullptr) GTEST_SKIP() << "needs the public robots, ../shared/data";
  using Table = Eigen::MatrixXd hopper::Motion::*;
  const std::pair<Table, const char*> tables[] = {{&hopper::Motion::accelerations, "accelerations"},
                                                  {&hopper::Motion::forces_N, "contact forces"},
                                                  {&hopper::Motion::efforts, "torques"}};
  for (const auto& [moved, name] : tables) {
    SCOPED_TRACE(name);
    hopper::Motion log =
        log_of(it->hopper, it->hop, {500, true, true, true, false, 0.0, false, true});
    Eigen::MatrixXd& table = log.*moved;
    const Eigen::Index rows = table.cols() - 1;
    table.rightCols(rows) = Eigen::MatrixXd(table.leftCols(rows));
    const hopper::HopperReport report = hopper::check_motion(it->hopper.robot, log, {});
    for (const auto& [other, what] : tables) EXPECT_EQ(is_moved(report, what), other == moved);
  }
}

TEST(SimulatorLogs, WithNoiseStillShowTheirRow) {
  const Hop* it = hop_of("op3");
  if (it == nullptr) GTEST_SKIP() << "needs the public robots, ../shared/data";
  for (const bool late : {false, true}) {
    const Checked found = check(*it, {500, true, true, true, false, 1.0, late});
    EXPECT_EQ(is_moved(found.report, "accelerations"), late);
    EXPECT_EQ(is_moved(found.report, "contact forces"), late);
  }
}

// Flags have the base's rows alone to tell: the hopper's forces are determined by them.
TEST(SimulatorLogs, WithFlagsARowLateAreReadSo) {
  const Hop* it = hop_of("hopper");
  if (it == nullptr) GTEST_SKIP() << "needs the public robots, ../shared/data";
  for (const bool late : {false, true}) {
    const Checked found = check(*it, {1000, true, true, false, true, 0.0, late});
    EXPECT_EQ(is_moved(found.report, "contact flags"), late);
    expect_goals(found.errors);
  }
}

TEST(SimulatorLogs, WithThresholdsThatAreStatedAndDoNotFitAreRefusedWithHelp) {
  const Hop* it = hop_of("hopper");
  if (it == nullptr) GTEST_SKIP() << "needs the public robots, ../shared/data";
  hopper::CheckOptions usual;
  usual.contact.height_m = 2e-3;
  usual.contact.speed_m_s = 0.1;
  try {
    check(*it, {1000, true, false, false, false, 0.0}, usual);
    FAIL() << "the landing moves faster than that";
  } catch (const io::SpecError& refusal) {
    const std::string text = refusal.what();
    EXPECT_NE(text.find("--contact-speed"), std::string::npos) << text;
    EXPECT_NE(text.find("accelerations in the log"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace torquewright::test
