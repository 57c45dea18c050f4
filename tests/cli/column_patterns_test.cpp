// SPDX-License-Identifier: Apache-2.0
// One --column for the columns of every joint. Oracle: the same motion under the names that need no
// option, of which the answer is the same but for what it was asked.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

/// Half a second of two joints that swing, 30 degrees and more; angles in this unit.
std::string swing(const std::string& header, double per_rad) {
  std::string csv = header + "\n";
  for (int i = 0; i <= 100; ++i) {
    const double t_s = 0.005 * i;
    csv += fmt::format("{},{:.9f},{:.9f},{},{}\n", t_s, per_rad * std::sin(2.0 * t_s),
                       per_rad * (0.5 - 0.4 * std::cos(3.0 * t_s)), 8.0 * std::cos(t_s), 5.0);
  }
  return csv;
}

json answer_of(const Workplace& place, const Words& words) {
  const Outcome outcome = place.run(words);
  EXPECT_LE(outcome.exit_code, 1) << outcome.err;
  json answer = json::parse(outcome.out);
  for (const char* key : {"inputs", "options"}) answer.erase(key);
  return answer;
}

TEST(ColumnPatterns, SayOfEveryJointWhatItsColumnIs) {
  const Workplace place;
  place.write("plain.csv", swing("time_s,knee_position_rad,hip_position_rad,knee_torque_Nm,"
                                 "hip_torque_Nm",
                                 1.0));
  place.write("named.csv", swing("t,pos.knee,pos.hip,knee_tau,hip_tau", 180.0 / M_PI));
  const std::string drive = in_specs("actuator/d151_knee.json");
  const Words joints = {"--joint", "knee=" + drive, "--joint", "hip=" + drive, "--json"};
  Words plain = {"actuator", "check", "plain.csv"};
  Words named = {"actuator",
                 "check",
                 "named.csv",
                 "--column",
                 "pos.{joint}={joint}.position:deg",
                 "--column",
                 "{joint}_tau={joint}.torque"};
  plain.insert(plain.end(), joints.begin(), joints.end());
  named.insert(named.end(), joints.begin(), joints.end());
  const json expected = answer_of(place, plain), found = answer_of(place, named);
  EXPECT_EQ(found["verdict"], expected["verdict"]);
  ASSERT_EQ(found["joints"].size(), expected["joints"].size());
  for (std::size_t i = 0; i < expected["joints"].size(); ++i) {
    // Degrees of nine decimals are radians to 2e-11.
    const auto peak_Nm = [i](const json& of) { return of["joints"][i]["peak_torque_Nm"]; };
    EXPECT_NEAR(peak_Nm(found).get<double>(), peak_Nm(expected).get<double>(), 1e-6);
  }
  for (const json& finding : found["findings"]) EXPECT_NE(finding["rule"], "columns-unread");
}

TEST(ColumnPatterns, AreRefusedWhereTheyFitNoColumn) {
  const Workplace place;
  place.write("named.csv", swing("t,pos.knee,pos.hip,knee_tau,hip_tau", 1.0));
  const Outcome outcome =
      place.run({"actuator", "check", "named.csv", "--column", "q_{joint}={joint}.position",
                 "--joint", "knee=" + in_specs("actuator/d151_knee.json")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("no column is as \"q_{joint}\" says of {joint}; joints are knee"),
            std::string::npos)
      << outcome.err;
  const Outcome near =
      place.run({"actuator", "check", "named.csv", "--column", "po.{joint}={joint}.position",
                 "--joint", "knee=" + in_specs("actuator/d151_knee.json")});
  EXPECT_EQ(near.exit_code, 2);
  EXPECT_NE(near.err.find("\"po.knee\" is near \"pos.knee\", which is there"), std::string::npos)
      << near.err;
}

}  // namespace
}  // namespace torquewright::cli_test
