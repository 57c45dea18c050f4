// SPDX-License-Identifier: Apache-2.0
// Bad logs, end to end: a good log by `identify simulate`, spoilt by hand in one way each, through
// `identify`. Oracles: docs/logs.md, which says for each fault whether it is refused, repaired with
// a finding or cannot tell; how many cells were spoilt; and the truth that was simulated (a Coulomb
// friction that the actuator does not declare), which every repair must still find.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/cli/bad_log_bench.hpp"

namespace torquewright::cli_test::bad_logs {
namespace {

using nlohmann::json;

TEST(BadLogs, TheGoodOneHasNothingToSay) {
  const Answer answer = identify(good());
  expect_truth(answer);
  EXPECT_TRUE(answer.report["data_findings"].empty());
}

// Row 2000 stands in line 2002: the header, and lines are counted from 1.
TEST(BadLogs, CellsWithoutANumberAreRefused) {
  for (const auto& [cell, said] : {std::pair{"inf", "\"inf\" is not a finite number"},
                                   std::pair{"-Infinity", "\"-Infinity\" is not a finite number"},
                                   std::pair{"1e999", "line 2002, column 5 (tau_Nm)"},
                                   std::pair{"off", "\"off\" is not a number"}}) {
    SpoiltLog log = good();
    log.at(2000, "tau_Nm") = cell;
    expect_refused(log, said);
    expect_refused(log, "log.csv: line 2002, column 5 (tau_Nm)");
  }
}

// Programs write nan where they have nothing to write.
TEST(BadLogs, CellsLeftEmptyLieOnALine) {
  SpoiltLog log = good();
  log.at(2000, "tau_Nm") = "";
  log.at(2500, "tau_Nm") = "nan";
  log.at(3000, "tau_Nm") = "-NaN";
  const Answer answer = identify(log);
  expect_truth(answer);
  expect_finding(answer, "note",
                 "output_torque_Nm: 3 empty cells: a straight line between numbers");
}

TEST(BadLogs, RowsThatRepeatTimeAreKept) {
  SpoiltLog log = good();
  log.at(2000, "t_s") = log.at(1999, "t_s");
  log.rows.insert(log.rows.begin() + 100, log.rows[100]);
  const Answer answer = identify(log);
  expect_truth(answer);
  expect_finding(answer, "note", "1 row of equal time and values: counted once");
  expect_finding(answer, "warning", "1 row of other values at the time of the row before");
}

TEST(BadLogs, CutLastLineIsLeftOut) {
  SpoiltLog log = good();
  log.rows.back().resize(2);
  const Answer answer = identify(log);
  expect_truth(answer);
  expect_finding(answer, "note", "the last line, 6401, ends within the row: it is left out");
}

TEST(BadLogs, TimeThatRunsBackwardsIsRefused) {
  SpoiltLog backwards = good();
  std::swap(backwards.rows[2000], backwards.rows[2001]);
  expect_refused(backwards, "line 2003, column 4 (t_s): time runs backwards");
}

TEST(BadLogs, GapIsCutAndSaid) {
  SpoiltLog log = good();
  log.erase_rows(2000, 200);
  const Answer answer = identify(log);
  expect_truth(answer);
  expect_finding(answer, "warning",
                 "run \"run_2\" has 1 gap in time, the longest 1.005 s after t = 1.995 s");
}

TEST(BadLogs, DeadVelocityIsLeftOutAndSaid) {
  SpoiltLog log = good();
  log.each("w_rad_s", [](double) { return 1.0; });
  const Answer answer = identify(log);
  expect_truth(answer);
  expect_finding(answer, "warning", "output_velocity_rad_s is 1 rad/s all through the log");
  expect_finding(answer, "warning", "output_position_rad does: it is left out");
}

TEST(BadLogs, DeadTorqueSensorCannotTell) {
  SpoiltLog log = good();
  log.each("tau_Nm", [](double) { return 3.0; });
  expect_cannot_tell(identify(log), "output_torque_Nm is 3 Nm all through the log");
}

TEST(BadLogs, WrappedAngleIsUnwrappedAndSaid) {
  SpoiltLog log = good();
  constexpr double kTurn = 2.0 * std::numbers::pi;
  int jumps = 0;
  const auto turns = [](double q) { return std::floor((q + std::numbers::pi) / kTurn); };
  for (std::size_t row = 1; row < log.rows.size(); ++row) {
    if (row % kRowsPerRun == 0) continue;
    jumps += turns(log.number(row, "q_rad")) != turns(log.number(row - 1, "q_rad"));
  }
  ASSERT_GT(jumps, 0);
  log.each("q_rad", [&](double q) { return q - kTurn * turns(q); });
  const Answer answer = identify(log);
  expect_truth(answer);
  expect_finding(
      answer, "note",
      fmt::format(
          "output_position_rad: {} jumps of a whole turn, a wrapped angle: unwrapped in 4 runs",
          jumps));
}

TEST(BadLogs, SaturatedChannelsAreMaskedAndSaid) {
  for (const auto& [column, quantity, limit] : {std::tuple{"i_A", "motor_current_A", 12.0},
                                                std::tuple{"tau_Nm", "output_torque_Nm", 8.0}}) {
    SpoiltLog log = good();
    int clipped = 0;
    log.each(column, [&, limit = limit](double value) {
      clipped += std::abs(value) >= limit;
      return std::clamp(value, -limit, limit);
    });
    const Answer answer = identify(log);
    expect_truth(answer);
    expect_finding(
        answer, "warning",
        fmt::format("{}: {} samples at the end of the channel's scale, saturated: masked", quantity,
                    clipped));
  }
}

TEST(BadLogs, IsolatedImpossibleSamplesAreDroppedAndSaid) {
  for (const auto& [column, quantity] :
       {std::pair{"tau_Nm", "output_torque_Nm"}, std::pair{"q_rad", "output_position_rad"}}) {
    SpoiltLog log = good();
    for (const std::size_t row : {500u, 1500u, 2500u, 4100u, 5500u, 6000u}) {
      log.at(row, column) = "500";
    }
    const Answer answer = identify(log);
    expect_truth(answer);
    expect_finding(answer, "warning", fmt::format("{}: 6 impossible samples", quantity));
  }
}

TEST(BadLogs, WrongUnitsAreRefusedWithTheScaleToWrite) {
  const auto degrees = [](double value) { return value * 180.0 / std::numbers::pi; };
  SpoiltLog position = good();
  position.each("q_rad", degrees);
  expect_refused(
      position,
      "rig.json#/columns/q_rad: d(output_position_rad)/dt is 57.3 times output_velocity_rad_s");
  expect_refused(position, R"(write {"quantity": "output_position_rad", "scale": 0.0174533})");
  SpoiltLog both = position;
  both.each("w_rad_s", degrees);
  expect_refused(both, "it looks like degrees");
  SpoiltLog current = good();
  current.each("i_A", [](double i) { return 1000.0 * i; });
  expect_refused(current,
                 R"(it looks like mA; write {"quantity": "motor_current_A", "scale": 0.001})");
}

TEST(BadLogs, ColumnsThatLogAndRigDoNotShareAreRefused) {
  SpoiltLog misspelt = good();
  misspelt.header[4] = "tau_nm";
  expect_refused(
      misspelt,
      "no column \"tau_Nm\", which the rig names as output_torque_Nm; did you mean \"tau_nm\"?");
  SpoiltLog more = good();
  more.header.emplace_back("extra");
  for (auto& row : more.rows) row.emplace_back("1");
  expect_refused(more, "column \"extra\" is not in the rig");
  json rig = rig_document();
  rig["ignore"] = {"extra"};
  expect_truth(identify(more, rig));
}

TEST(BadLogs, HoldOutRunThatDoesNotExistIsRefused) {
  json rig = rig_document();
  rig["holdout_runs"] = {"run4"};
  expect_refused(good(), "rig.json#/holdout_runs/0: no run \"run4\"; did you mean \"run_4\"?", rig);
}

// A second of each run: no block of 1.5 s.
TEST(BadLogs, RunsShorterThanNeededCannotTell) {
  SpoiltLog log = good();
  SpoiltLog parts = log;
  parts.rows.clear();
  for (std::size_t row = 0; row < log.rows.size(); ++row) {
    if (row % kRowsPerRun < 200) parts.rows.push_back(log.rows[row]);
  }
  const Answer answer = identify(parts);
  expect_cannot_tell(answer, "the runs to fit hold 0 s of use, less than the 3 needed");
  expect_finding(answer, "warning", "4 stretches are shorter than 1.5 s");
}

TEST(BadLogs, JointThatNeverMovesCannotTell) {
  expect_cannot_tell(identify(simulated(0.0)), "the joint never moves");
}

TEST(BadLogs, VelocityAgainstPositionIsRefused) {
  SpoiltLog log = good();
  log.each("w_rad_s", [](double w) { return -w; });
  expect_refused(log, "output_velocity_rad_s and d(output_position_rad)/dt have opposite signs");
}

// No effect is named for a sign: the model is wrong, and the suspicion is said.
TEST(BadLogs, TorqueOfTheWrongSignIsSuspected) {
  SpoiltLog log = good();
  log.each("tau_Nm", [](double tau) { return -tau; });
  const Answer answer = identify(log);
  EXPECT_EQ(answer.outcome.exit_code, 1);
  EXPECT_EQ(answer.report["verdict"], "unexplained");
  EXPECT_TRUE(answer.report["effects_added"].empty());
  EXPECT_EQ(answer.written, std::vector<std::string>{});
  expect_finding(answer, "warning", "a torque of the wrong sign is suspected");
}

TEST(BadLogs, VelocityWithoutTimeIsRefused) {
  SpoiltLog log = good();
  log.drop("t_s");
  json rig = rig_document();
  rig["columns"].erase("t_s");
  expect_refused(log, "a log without time is a map of holding values over positions", rig);
}

/// A motor of cogging of order 7 held at angles that are approached from both sides.
SpoiltLog map() {
  std::string text = "run,q_rad,i_A\n";
  const double torque_per_A = 0.0865;
  for (int run = 1; run <= 4; ++run) {
    for (int k = 0; k < 720; ++k) {
      const double q = 2.0 * std::numbers::pi * (k < 360 ? k : 720 - k) / 360.0 + 0.01 * run;
      const double noise = 2e-3 * std::sin(97.0 * k * run);
      const double torque = 0.02 * std::sin(7.0 * q + 0.3);
      text += fmt::format("map_{},{:.9g},{:.9g}\n", run, q, -torque / torque_per_A + noise);
    }
  }
  return SpoiltLog(text);
}

// A map has no speed, and so no effect of one. What was put in, 0.02 Nm of order 7 at the motor
// (9.3 times as much at the output), is found; no order of the output is 65.1.
TEST(BadLogs, LogWithoutTimeIsAMap) {
  const json rig = {
      {"kind", "rig"},
      {"version", 1},
      {"name", "held at angles"},
      {"columns", {{"run", "run"}, {"q_rad", "motor_position_rad"}, {"i_A", "motor_current_A"}}},
      {"load", {{"type", "free"}, {"inertia_kg_m2", 0}}},
      {"holdout_runs", {"map_4"}}};
  const Answer answer = identify(map(), rig);
  EXPECT_EQ(answer.outcome.exit_code, 0) << answer.outcome.err;
  ASSERT_EQ(answer.report["effects_added"].size(), 1u) << answer.outcome.out;
  const json& effect = answer.report["effects_added"][0];
  EXPECT_EQ(effect["effect"], "cogging_torque");
  const json& harmonic = effect["parameters"]["harmonics"][0];
  EXPECT_EQ(harmonic["order"], 7);
  EXPECT_NEAR(harmonic["amplitude_Nm"].get<double>(), 0.02 * 9.3, 0.001 * 9.3 * 0.02);
  EXPECT_NEAR(harmonic["phase_rad"].get<double>(), 0.3, 0.001);
  EXPECT_TRUE(answer.report["confounded"].empty());
}

}  // namespace
}  // namespace torquewright::cli_test::bad_logs
