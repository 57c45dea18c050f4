// SPDX-License-Identifier: Apache-2.0
// Small cases that once went wrong, with the command and the right answer of each. Oracle: what
// each case's README and make.py state as the truth. The cases are no part of the repository.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

constexpr double kErrors = 3.0;

fs::path cases() {
  const char* variable = std::getenv("TORQUEWRIGHT_DATA");
  const fs::path data = variable != nullptr ? fs::path(variable)
                                            : fs::path(TORQUEWRIGHT_SOURCE_DIR) / "../shared/data";
  return fs::is_directory(data / "cases") ? fs::canonical(data / "cases") : fs::path();
}

class SmallCases : public testing::Test {
 protected:
  void SetUp() override {
    if (cases().empty()) GTEST_SKIP() << "no ../shared/data/cases: the cases are not here";
  }

  static std::string file(const char* name) { return (cases() / name).string(); }

  /// What the case's make.py writes, identified; of exit code 3 where not all can be told apart.
  json identified(const char* number, const char* rig, int exit_code = 0) const {
    const std::string make = "cd '" + place_.path().string() + "' && python3 '" +
                             (cases() / number / "make.py").string() + "'";
    EXPECT_EQ(std::system(make.c_str()), 0) << make;
    const Outcome outcome =
        place_.run({"identify", "log.csv", "--rig", (cases() / number / rig).string(), "--actuator",
                    (cases() / number / "actuator.json").string(), "--json"});
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    return outcome.out.empty() ? json() : json::parse(outcome.out);
  }

  Workplace place_;
};

struct Truth {
  const char* effect;
  const char* parameter;
  double value;
};

/// These are named and nothing else, each within its errors.
void expect_named(const json& report, const std::vector<Truth>& truths) {
  ASSERT_TRUE(report.contains("effects_added"));
  EXPECT_EQ(report["verdict"], "explained");
  EXPECT_EQ(report["effects_added"].size(), truths.size());
  for (const Truth& truth : truths) {
    bool is_named = false;
    for (const json& effect : report["effects_added"]) {
      EXPECT_EQ(effect["certain"], true) << effect["effect"];
      if (effect["effect"] != truth.effect) continue;
      is_named = true;
      EXPECT_NEAR(effect["parameters"][truth.parameter].get<double>(), truth.value,
                  kErrors * effect["standard_error"][truth.parameter].get<double>())
          << truth.effect;
    }
    EXPECT_TRUE(is_named) << truth.effect;
  }
}

TEST_F(SmallCases, TwoNoisyPositionBesideACleanVelocity) {
  expect_named(identified("2", "rig.json"), {{"gravity_imbalance", "amplitude_Nm", 3.0},
                                             {"coulomb_friction", "coulomb_Nm", 2.4},
                                             {"viscous_friction", "viscous_Nm_s_rad", 2.9}});
}

// The same without the velocity, 0.1 A of noise for 0.01: which drag it is no longer shows, and
// what is certain is so.
TEST_F(SmallCases, TwoWithoutTheVelocity) {
  const json report = identified("2", "rig_nov.json", 3);
  const std::map<std::string, Truth> truths = {
      {"gravity_imbalance", {"gravity_imbalance", "amplitude_Nm", 3.0}},
      {"coulomb_friction", {"coulomb_friction", "coulomb_Nm", 2.4}},
      {"viscous_friction", {"viscous_friction", "viscous_Nm_s_rad", 2.9}}};
  int certain = 0;
  for (const json& effect : report["effects_added"]) {
    if (effect["certain"] == false) continue;
    const auto truth = truths.find(effect["effect"].get<std::string>());
    ASSERT_NE(truth, truths.end()) << effect["effect"];
    EXPECT_NEAR(effect["parameters"][truth->second.parameter].get<double>(), truth->second.value,
                kErrors * effect["standard_error"][truth->second.parameter].get<double>());
    ++certain;
  }
  EXPECT_GE(certain, 2);
}

// Beside Coulomb's friction a power of the speed; a viscous drag in Coulomb's place, with another
// power, leaves as much.
TEST_F(SmallCases, FiveDragThatFlattensWithSpeed) {
  const json report = identified("5", "rig.json", 3);
  const std::map<std::string, std::vector<Truth>> truths = {
      {"coulomb_friction", {{"coulomb_friction", "coulomb_Nm", 14.5}}},
      {"power_law_drag",
       {{"power_law_drag", "coefficient_Nm", 20.9}, {"power_law_drag", "exponent", 0.7}}}};
  ASSERT_TRUE(report.contains("effects_added"));
  EXPECT_EQ(report["effects_added"].size(), truths.size());
  for (const json& effect : report["effects_added"]) {
    const auto truth = truths.find(effect["effect"].get<std::string>());
    ASSERT_NE(truth, truths.end()) << effect["effect"];
    for (const Truth& each : truth->second) {
      EXPECT_NEAR(effect["parameters"][each.parameter].get<double>(), each.value,
                  kErrors * effect["standard_error"][each.parameter].get<double>())
          << each.parameter;
    }
  }
}

TEST_F(SmallCases, EightRecorderThatPauses) {
  expect_named(identified("8", "rig.json"), {{"coulomb_friction", "coulomb_Nm", 0.12},
                                             {"viscous_friction", "viscous_Nm_s_rad", 0.07}});
}

TEST_F(SmallCases, TenTwoSoundMotorsTogether) {
  const Outcome outcome = run({"actuator", "lint", file("10/a.json"), file("10/b.json"), "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  EXPECT_EQ(json::parse(outcome.out)["verdict"], "pass");
}

// 418.6 N m on three planets and 94.375 mm; the torque is rounded to 0.05 of it.
TEST_F(SmallCases, ElevenForceOfAShiftedRing) {
  const Outcome outcome = run({"gearbox", "evaluate", file("11/problem.json"), "--teeth",
                               "21,43,108", "--profile-shift", "0.438,0.0426,0", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\"tangential_force_N\""), std::string::npos);
  const Outcome strength = run({"gearbox", "strength", file("11/strength.json"), "--torque", "500",
                                "--side", "joint", "--json"});
  for (const std::string& text : {outcome.out, strength.out}) {
    bool is_there = false;
    for (std::size_t at = text.find("\"tangential_force_N\":"); at != std::string::npos;
         at = text.find("\"tangential_force_N\":", at + 1)) {
      is_there = is_there || std::abs(std::stod(text.substr(at + 21)) - 1478.5) < 0.2;
    }
    EXPECT_TRUE(is_there) << text;
  }
}

}  // namespace
}  // namespace torquewright::cli_test
