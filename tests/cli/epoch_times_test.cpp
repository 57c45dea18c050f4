// SPDX-License-Identifier: Apache-2.0
// Clocks that count from 1970, as in bags of ROS: a row each 2^-10 s is told from the next, and an
// answer is the one that a clock from zero gives.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using Words = std::vector<std::string>;

const std::string kEpochKnee = in_repository("specs/actuator/d151_knee.json").string();
const std::string kEpochRig = in_repository("specs/rig/knee_sweep.json").string();

constexpr long kEpoch_s = 1'700'000'000;
constexpr int kRows = 200;
// A power of two: sums with the epoch are exact doubles, so that both clocks hold the same times.
constexpr double kStep_s = 1.0 / 1024.0;

std::string time_of(int row, long start_s) {
  std::string text(40, '\0');
  const int size = std::snprintf(text.data(), text.size(), "%.10f",
                                 static_cast<double>(start_s) + row * kStep_s);
  text.resize(static_cast<std::size_t>(size));
  return text;
}

/// A knee that swings up by a parabola: position, velocity, torque.
std::string swing(long start_s) {
  std::string table = "time_s,knee_position_rad,knee_velocity_rad_s,knee_torque_Nm\n";
  for (int row = 0; row < kRows; ++row) {
    const double t_s = row * kStep_s;
    table += time_of(row, start_s) + "," + std::to_string(2.0 * t_s * t_s) + "," +
             std::to_string(4.0 * t_s) + ",20\n";
  }
  return table;
}

std::string excitation(long start_s) {
  std::string table = "time_s,motor_current_A,output_velocity_rad_s\n";
  for (int row = 0; row < kRows; ++row) table += time_of(row, start_s) + ",0.5,0.1\n";
  return table;
}

const std::string kNote =
    "note [clock] times are counted from the first row, 1700000000 s of the file's clock\n";

/// What a command says to the same table at both clocks.
void expect_same_answer(const std::string& table, const std::string& table_of_epoch,
                        const Words& command) {
  const Workplace place;
  place.write("motion.csv", table);
  const Outcome plain = place.run(command);
  place.write("motion.csv", table_of_epoch);
  const Outcome epoch = place.run(command);
  EXPECT_EQ(plain.exit_code, 0) << plain.err;
  EXPECT_EQ(epoch.exit_code, 0) << epoch.err;
  EXPECT_EQ(with(epoch.out, kNote, ""), plain.out);
  EXPECT_NE(plain.out.find(" s"), std::string::npos) << "says no time";
}

TEST(EpochTimes, OfACheckAreSaidFromItsStart) {
  const std::string joint = "knee=" + kEpochKnee;
  expect_same_answer(swing(0), swing(kEpoch_s),
                     {"actuator", "check", "motion.csv", "--joint", joint});
}

// Oracle: the picture of the same motion from zero.
TEST(EpochTimes, OfAPictureAreThoseFromItsStart) {
  const Workplace place;
  place.write("plain.csv", swing(0));
  place.write("epoch.csv", swing(kEpoch_s));
  for (const std::string name : {"plain", "epoch"}) {
    const Outcome outcome = place.run({"actuator", "check", name + ".csv", "--joint",
                                       "knee=" + kEpochKnee, "--plot", name + ".svg"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  EXPECT_EQ(place.text("epoch.svg").find("e+09"), std::string::npos);
  std::string epoch = place.text("epoch.svg");  // names the file in its title and above its curves
  for (int named = 0; named < 2; ++named) epoch = with(epoch, "epoch.csv", "plain.csv");
  EXPECT_EQ(epoch, place.text("plain.svg"));
}

// Oracle: the excitation's own times.
TEST(EpochTimes, OfASimulatedLogReadBackTheSame) {
  const Workplace place;
  place.write("motion.csv", excitation(kEpoch_s));
  const Outcome outcome = place.run({"identify", "simulate", kEpochKnee, "--rig", kEpochRig,
                                     "--excitation", "motion.csv", "-o", "log.csv"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream lines(place.text("log.csv"));
  std::string line;
  std::getline(lines, line);
  const std::string columns = line.substr(0, line.find("t_s"));
  const auto column = std::count(columns.begin(), columns.end(), ',');
  int row = 0;
  for (; std::getline(lines, line); ++row) {
    for (long i = 0; i < column; ++i) line.erase(0, line.find(',') + 1);
    EXPECT_EQ(std::stod(line), static_cast<double>(kEpoch_s) + row * kStep_s);
  }
  EXPECT_EQ(row, kRows);
}

}  // namespace
}  // namespace torquewright::cli_test
