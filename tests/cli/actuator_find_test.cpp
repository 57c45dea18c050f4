// SPDX-License-Identifier: Apache-2.0
// Which drives fit. Oracle: lines between two numbers, by hand.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

/// A folder of three drives, and two documents that are none.
struct Shelf : Workplace {
  Shelf() {
    write("strong.json",
          R"({"kind": "actuator", "version": 1, "mass_kg": 3,
              "envelope": {"peak_torque_Nm": 100, "no_load_speed_rad_s": 20}})");
    write("light.json",
          R"({"kind": "actuator", "version": 1, "mass_kg": 1,
              "envelope": {"peak_torque_Nm": 60, "no_load_speed_rad_s": 20}})");
    write("silent.json",
          R"({"kind": "actuator", "version": 1,
              "envelope": {"peak_torque_Nm": 80, "no_load_speed_rad_s": 20}})");
    write("broken.json", R"({"kind": "actuator", "version": 1})");
  }
};

// At 10 rad/s: 50, 30 and 40 Nm.
TEST(ActuatorFind, RanksByMarginAndSaysWhyOthersFail) {
  const Shelf place;
  const Outcome found = place.run({"actuator", "find", "--need", "35@10", "--in", ".", "--json"});
  EXPECT_EQ(found.exit_code, 0) << found.err;
  const json list = json::parse(found.out);
  ASSERT_EQ(list["drives"].size(), 3u);
  EXPECT_EQ(list["drives"][0]["drive"], "strong");
  EXPECT_NEAR(list["drives"][0]["margin_share"].get<double>(), 50.0 / 35.0 - 1.0, 1e-9);
  EXPECT_EQ(list["drives"][1]["drive"], "silent");
  EXPECT_FALSE(list["drives"][2]["fits"].get<bool>());
  EXPECT_EQ(list["drives"][2]["reasons"][0], "30 of 35 Nm at 10 rad/s (envelope)");
  ASSERT_EQ(list["left_out"].size(), 1u);
  EXPECT_NE(list["left_out"][0].get<std::string>().find("broken: needs \"motor\""),
            std::string::npos);
}

TEST(ActuatorFind, IsUndecidedWhereADocumentIsSilent) {
  const Shelf place;
  const Outcome found =
      place.run({"actuator", "find", "--need", "35@10", "--mass-below", "2", "--in", "."});
  EXPECT_EQ(found.exit_code, 3);
  EXPECT_NE(found.out.find("0 of 3 drives fit, 1 would if what they do not state does"),
            std::string::npos)
      << found.out;
}

TEST(ActuatorFind, FailsWhereNoneFits) {
  const Shelf place;
  EXPECT_EQ(place.run({"actuator", "find", "--need", "60@10", "--in", "."}).exit_code, 1);
}

TEST(ActuatorFind, RefusesWhatIsNoQuestion) {
  const Shelf place;
  EXPECT_EQ(place.run({"actuator", "find", "--need", "0@10"}).exit_code, 2);
  EXPECT_EQ(place.run({"actuator", "find", "--need", "5@10", "--in", "nowhere"}).exit_code, 2);
  EXPECT_EQ(place.run({"actuator", "find", "--need", "5@10", "--ratio", "9:3"}).exit_code, 2);
}

TEST(ActuatorFind, HasACatalogueThatInitWrites) {
  const Workplace place;
  const Outcome found = place.run({"actuator", "find", "--need", "30@10", "--json"});
  EXPECT_EQ(found.exit_code, 0) << found.err;
  const std::string best = json::parse(found.out)["drives"][0]["drive"];
  EXPECT_EQ(place.run({"init", "actuator", "--from", best, "-o", "best.json"}).exit_code, 0);
  EXPECT_EQ(place.run({"actuator", "mor", "best.json", "--need", "30@10"}).exit_code, 0);
  const Outcome unknown = place.run({"init", "actuator", "--from", "unitree_a2"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("did you mean unitree_a1?"), std::string::npos) << unknown.err;
}

TEST(InitEnvelope, IsTakenByWhatAsksForACurve) {
  const Workplace place;
  ASSERT_EQ(place.run({"init", "actuator", "--envelope", "-o", "curve.json"}).exit_code, 0);
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"actuator", "mor", "curve.json"},
           {"actuator", "mor", "curve.json", "--need", "20@10"},
           {"actuator", "mor", "curve.json", "--format", "isaac-lab"},
           {"actuator", "mor", "curve.json", "--format", "mujoco"},
           {"actuator", "mor", "curve.json", "--format", "c"},
           {"actuator", "lint", "curve.json"}}) {
    const Outcome outcome = place.run(words);
    EXPECT_EQ(outcome.exit_code, 0) << testing::PrintToString(words) << outcome.err;
    for (const char* word : {"nan", "inf,", "=inf"}) {
      EXPECT_EQ(outcome.out.find(word), std::string::npos) << testing::PrintToString(words);
    }
  }
  const Outcome winding =
      place.run({"actuator", "mor", "curve.json", "--winding-temperature", "350"});
  EXPECT_EQ(winding.exit_code, 2);
  EXPECT_NE(winding.err.find("a winding's temperature needs a winding"), std::string::npos)
      << winding.err;
}

}  // namespace
}  // namespace torquewright::cli_test
