// SPDX-License-Identifier: Apache-2.0
// The published logs through the whole identification. Oracles: what a study by hand found in them
// (the figures beside the data, held out), and what must not be named. The logs are no part of the
// repository.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "identification/answer/identify.hpp"
#include "io/documents/document.hpp"
#include "tests/long_run.hpp"

namespace torquewright::identification {
namespace {

namespace fs = std::filesystem;

const fs::path kRigFolder = fs::path(TORQUEWRIGHT_SOURCE_DIR) / "tests/real_data/rigs";

fs::path log_folder() {
  const char* variable = std::getenv("TORQUEWRIGHT_DATA");
  const fs::path data = variable != nullptr ? fs::path(variable)
                                            : fs::path(TORQUEWRIGHT_SOURCE_DIR) / "../shared/data";
  return fs::is_directory(data / "logs") ? data / "logs" : fs::path();
}

class RealLogs : public testing::Test {
 protected:
  void SetUp() override {
    if (log_folder().empty()) GTEST_SKIP() << "no ../shared/data/logs: the logs are not here";
  }

  static Identification identified(const char* rig_file, const char* actuator_file,
                                   const std::vector<std::string>& files,
                                   const std::vector<std::string>& holdout_runs = {}) {
    Rig rig = read_rig(io::read_document(kRigFolder / rig_file, "rig"));
    if (!holdout_runs.empty()) rig.holdout_runs = holdout_runs;
    std::vector<JointActuator> actuators;
    for (const std::string& joint : rig.joints) {
      actuators.push_back({joint, actuator::read_actuator(kRigFolder / actuator_file)});
    }
    std::vector<fs::path> paths;
    for (const std::string& file : files) paths.push_back(log_folder() / file);
    return identify(paths, rig, actuators);
  }
};

const EquationResult* equation(const Identification& found, const std::string& quantity,
                               const std::string& joint = "") {
  for (const EquationResult& each : found.equations) {
    if (each.quantity == quantity && each.joint == joint) return &each;
  }
  return nullptr;
}

const NamedEffect* added(const EquationResult& result, const std::string& effect) {
  const auto at = std::find_if(result.added.begin(), result.added.end(),
                               [&](const NamedEffect& each) { return each.effect == effect; });
  return at == result.added.end() ? nullptr : &*at;
}

TEST_F(RealLogs, DoublePendulumsElbowHasCoulombFrictionOnly) {
  const Identification found =
      identified("dfki_double_pendulum.json", "ak80_6_actuator.json",
                 {"dfki_double_pendulum/heldout.csv", "dfki_double_pendulum/train_a.csv",
                  "dfki_double_pendulum/train_b.csv"});
  const EquationResult* elbow = equation(found, "reported_torque_Nm", "elbow");
  ASSERT_NE(elbow, nullptr);
  const NamedEffect* coulomb = added(*elbow, "coulomb_friction");
  ASSERT_NE(coulomb, nullptr);
  // Found by hand: 0.16 Nm; 0.233 -> 0.157 Nm held out, and load friction refused.
  EXPECT_NEAR(coulomb->parameters.value("coulomb_Nm", NAN), 0.16, 0.02);
  EXPECT_LE(elbow->after.holdout_rms, 0.157 * 1.05);
  EXPECT_EQ(added(*elbow, "load_dependent_friction"), nullptr);
  const EquationResult* shoulder = equation(found, "reported_torque_Nm", "shoulder");
  ASSERT_NE(shoulder, nullptr);
  EXPECT_EQ(added(*shoulder, "gear_ripple"), nullptr);
}

std::vector<double> orders_of(const NamedEffect& effect) {
  std::vector<double> orders;
  for (const FoundWave& wave : effect.parameters.waves) orders.push_back(wave.order);
  std::sort(orders.begin(), orders.end());
  return orders;
}

/// Whether the log may have the effect: it is named, or stands in a group of what was.
bool may_be(const EquationResult& result, const std::string& effect) {
  if (added(result, effect) != nullptr) return true;
  return std::any_of(result.confounded.begin(), result.confounded.end(), [&](const auto& group) {
    return std::find(group.effects.begin(), group.effects.end(), effect) != group.effects.end();
  });
}

double named(const NamedEffect& effect, const char* parameter) {
  return effect.parameters.value(parameter, NAN);
}

// By hand: orders 7, 28, 14, 36, 12, 84; 0.667 -> 0.268 A on other trials. Order 84 lies above the
// band of 8 Hz at this speed, and without compensation the motor jumps from tooth to tooth at up to
// 7 rad/s, where 28 and 36 do as well.
TEST_F(RealLogs, BareMotorsCoggingHasTheHarmonicsFoundByHand) {
  const Identification found = identified("odrive_cogging.json", "odrive_actuator.json",
                                          {"odrive_cogging/slow_velocity_nocomp.csv"});
  const EquationResult* current = equation(found, "motor_current_A");
  ASSERT_NE(current, nullptr);
  const NamedEffect* cogging = added(*current, "cogging_torque");
  ASSERT_NE(cogging, nullptr);
  const std::vector<double> orders = orders_of(*cogging), by_hand = {7.0, 12.0, 14.0};
  EXPECT_TRUE(std::includes(orders.begin(), orders.end(), by_hand.begin(), by_hand.end()));
  EXPECT_LE(current->after.holdout_rms, 0.27);
}

TEST_F(RealLogs, BareMotorsCoggingAtEvenSpeedHasAllHarmonicsOfTheBand) {
  if (!test::is_long_run()) GTEST_SKIP() << test::kLeftOut;
  const Identification found = identified("odrive_cogging.json", "odrive_actuator.json",
                                          {"odrive_cogging/slow_velocity_comp.csv"});
  const EquationResult* current = equation(found, "motor_current_A");
  ASSERT_NE(current, nullptr);
  const NamedEffect* cogging = added(*current, "cogging_torque");
  ASSERT_NE(cogging, nullptr);
  const std::vector<double> orders = orders_of(*cogging), by_hand = {7.0, 12.0, 14.0, 28.0, 36.0};
  EXPECT_TRUE(std::includes(orders.begin(), orders.end(), by_hand.begin(), by_hand.end()));
  // The other log's amplitude of order 7 is 0.0230 Nm with the stated 0.03 Nm/A, so 0.767 A: the
  // same motor, recorded apart. A bare motor hardly tells its torque constant.
  const double constant_Nm_A = current->corrected.empty() ? 0.03 : current->corrected[0].value;
  for (const FoundWave& wave : cogging->parameters.waves) {
    if (wave.order != 7.0) continue;
    EXPECT_NEAR(wave.amplitude.value / constant_Nm_A, 0.767, 0.040);
  }
  // Friction by position as strong as that would push.
  EXPECT_EQ(added(*current, "position_dependent_friction"), nullptr);
  EXPECT_LE(current->after.holdout_rms, 0.27);
}

/// By which the sensor is late, or lags: over these runs' motion the two are one.
double lateness_s(const EquationResult& torque) {
  const NamedEffect* delay = added(torque, "channel_delay");
  if (delay != nullptr) return named(*delay, "delay_s");
  const NamedEffect* lag = added(torque, "torque_lag");
  return lag != nullptr ? named(*lag, "time_constant_s") : 0.0;
}

/// What the two good runs of the cycloidal drive hold: a sensor that is late (by hand 80 ms in one,
/// 70 in the other) or lags, load friction, and friction beside it.
void expect_late_sensor_and_load_friction(const Identification& found, double goal_Nm) {
  const EquationResult* torque = equation(found, "output_torque_Nm");
  ASSERT_NE(torque, nullptr);
  EXPECT_LE(torque->after.holdout_rms, goal_Nm);
  EXPECT_TRUE(may_be(*torque, "channel_delay"));
  EXPECT_NEAR(lateness_s(*torque), 0.075, 0.010);
  EXPECT_TRUE(may_be(*torque, "coulomb_friction"));
  EXPECT_NE(added(*torque, "load_dependent_friction"), nullptr);
}

TEST_F(RealLogs, CycloidalDrivesSensorIsLateAndItsVelocityIsOff) {
  const Identification found = identified("romela_cycloidal.json", "romela_actuator.json",
                                          {"romela_cycloidal/torqueripple2.csv"});
  expect_late_sensor_and_load_friction(found, 1.75);
  const EquationResult* velocity = equation(found, "output_velocity_rad_s");
  ASSERT_NE(velocity, nullptr);
  const NamedEffect* mismatch = added(*velocity, "velocity_mismatch");
  ASSERT_NE(mismatch, nullptr);
  EXPECT_NEAR(mismatch->parameters.value("scale", NAN), 3.2, 0.16);
}

TEST_F(RealLogs, SecondCycloidalLogFallsBelowItsGoal) {
  if (!test::is_long_run()) GTEST_SKIP() << test::kLeftOut;
  expect_late_sensor_and_load_friction(identified("romela_cycloidal.json", "romela_actuator.json",
                                                  {"romela_cycloidal/torqueripple3.csv"}),
                                       1.63);
}

// The question of load friction, settled: what one log says holds in the other, which was recorded
// apart and never fitted. By hand 2.57 -> 1.63 Nm with a delay and Coulomb friction.
TEST_F(RealLogs, CycloidalLogsForetellOneAnother) {
  for (const char* held_out : {"torqueripple2", "torqueripple3"}) {
    const Identification found = identified(
        "romela_cycloidal.json", "romela_actuator.json",
        {"romela_cycloidal/torqueripple2.csv", "romela_cycloidal/torqueripple3.csv"}, {held_out});
    expect_late_sensor_and_load_friction(found, 0.8);
  }
}

// No argument in the data refuses them (docs/identification.md); nothing is named, at least.
TEST_F(RealLogs, SixCycloidalLogsNameNothingOfTheTorque) {
  std::vector<std::string> files;
  for (const char* name :
       {"contact2", "contact3", "normal1", "normal2", "torqueripple1", "torqueripple4"}) {
    files.push_back("romela_cycloidal/" + std::string(name) + ".csv");
  }
  const Identification found = identified("romela_cycloidal.json", "romela_actuator.json", files);
  const EquationResult* torque = equation(found, "output_torque_Nm");
  ASSERT_NE(torque, nullptr);
  EXPECT_TRUE(torque->added.empty());
  EXPECT_NE(found.verdict, Verdict::kExplained);
}

// Eleven seconds: what is missing cannot be told, and Coulomb friction is not claimed. By hand the
// torque is 16 ms out of step.
TEST_F(RealLogs, SimplePendulumCannotTell) {
  const Identification found =
      identified("dfki_simple_pendulum.json", "ak80_6_actuator.json",
                 {"dfki_simple_pendulum/ddp.csv", "dfki_simple_pendulum/direct_collocation.csv"});
  EXPECT_EQ(found.verdict, Verdict::kCannotTell);
  for (const EquationResult& each : found.equations) {
    EXPECT_EQ(added(each, "coulomb_friction"), nullptr);
  }
  EXPECT_TRUE(may_be(found.equations.front(), "channel_delay"));
  EXPECT_NEAR(lateness_s(found.equations.front()), 0.016, 0.006);
}

}  // namespace
}  // namespace torquewright::identification
