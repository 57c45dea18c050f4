// SPDX-License-Identifier: Apache-2.0
// `gearbox tolerances` as a user runs it: exit codes, JSON, what it refuses. The numbers:
// tests/gearbox/tolerances.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/documents/schema.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

Outcome tolerances(std::vector<std::string> options) {
  options.insert(options.begin(),
                 {"gearbox", "tolerances", in_specs("gearbox/d151_knee_result.json")});
  return run(options);
}

TEST(Tolerances, PrintWhatTheySayInJson) {
  const Outcome outcome = tolerances({"--json", "--draws", "500"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  const json report = json::parse(outcome.out);
  EXPECT_TRUE(io::conforms(report, "tolerance_report"));
  EXPECT_EQ(report["yield"]["good"], 500);
  EXPECT_EQ(report["meshes"].size(), 3U);
  EXPECT_EQ(report["limits"].size(), 16U);
  EXPECT_EQ(tolerances({"--json", "--draws", "500"}).out, outcome.out);
  const Outcome text = tolerances({"--draws", "500"});
  // Oracle: Wilson's interval of n of n, n/(n + z^2) to 1.
  EXPECT_EQ(
      text.out.rfind("yield 100.00 % (99.24 % to 100.00 % with 95 % confidence): 500 of 500 drawn "
                     "gearboxes are good (seed 1, even distribution between limits)\n",
                     0),
      0U)
      << text.out;
}

TEST(Tolerances, TakeStatedLimits) {
  const Outcome outcome =
      tolerances({"--json", "--draws", "10", "--centre-distance", "0.02", "--tooth-thickness",
                  "-0.06:-0.03,sun=-0.05:-0.02", "--shift-tolerance", "0.01", "--tip-tolerance",
                  "0.03", "--distribution", "normal"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const json& limit : json::parse(outcome.out)["limits"]) {
    const std::string name = limit["name"];
    const bool is_ring = name.find("ring") != std::string::npos;
    const std::pair<double, double> expected =
        name == "centre_distance"             ? std::pair(-0.02, 0.02)
        : name == "tooth_thickness.sun"       ? std::pair(-0.05, -0.02)
        : name.starts_with("tooth_thickness") ? std::pair(-0.06, -0.03)
        : name.starts_with("profile_shift")   ? std::pair(-0.01, 0.01)
        : is_ring                             ? std::pair(0.0, 0.03)
                                              : std::pair(-0.03, 0.0);
    EXPECT_EQ(limit["least"], expected.first) << name;
    EXPECT_EQ(limit["greatest"], expected.second) << name;
    EXPECT_EQ(limit["is_assumed"], false) << name;
  }
}

TEST(Tolerances, JudgeTheYield) {
  EXPECT_EQ(tolerances({"--draws", "500", "--min-yield", "0.99"}).exit_code, 0);
  const Outcome missed =
      tolerances({"--draws", "500", "--max-backlash", "1e-5", "--min-yield", "0.5"});
  EXPECT_EQ(missed.exit_code, 1);
  EXPECT_NE(missed.out.find("at least 50.00 % are asked for: missed\n"), std::string::npos);
  EXPECT_NE(missed.out.find("     500 have more backlash than 1e-05 rad at the output\n"),
            std::string::npos)
      << missed.out;
  const Outcome open = tolerances({"--draws", "10", "--min-yield", "0.9"});
  EXPECT_EQ(open.exit_code, 3);
  EXPECT_NE(open.out.find("at least 90.00 % are asked for: undecided, more --draws would tell\n"),
            std::string::npos);
}

TEST(Tolerances, RefuseWhatIsNoLimit) {
  const auto refusal = [](std::vector<std::string> options) {
    const Outcome outcome = tolerances(std::move(options));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    return outcome.err;
  };
  for (const char* limit : {"-0.03", "-0.03:-0.06", "nan:0", "-2:0", "0:0x1", ":", "sun=:0"}) {
    EXPECT_NE(refusal({"--tooth-thickness", limit})
                  .find("needs two lengths from -1 to 1 mm, the lesser first, as in -0.06:-0.03"),
              std::string::npos)
        << limit;
  }
  EXPECT_EQ(
      refusal({"--tooth-thickness", "moon=-0.06:-0.03"}),
      "--tooth-thickness: \"moon=-0.06:-0.03\" names no gear; 3k has sun, planet_1, planet_2, "
      "fixed_ring, output_ring\n");
  EXPECT_NE(refusal({"--centre-distance", "nan"}), "");
  EXPECT_NE(refusal({"--min-yield", "1.5"}), "");
  EXPECT_NE(refusal({"--draws", "0"}), "");
  EXPECT_NE(refusal({"--design", "2"}).find("--design 2 is not there; the number of designs is 1"),
            std::string::npos);
}

}  // namespace
}  // namespace torquewright::cli_test
