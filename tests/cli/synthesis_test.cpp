// SPDX-License-Identifier: Apache-2.0
// `gearbox optimize` of a problem with `synthesis`, as a user runs it, and what is done with its
// result.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/documents/schema.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

/// Eight lines and a few choices, so that it takes a second.
const char* const kEightLines = R"({"kind": "gearbox_problem", "version": 1,
 "topology": "3k",
 "target_ratio": 20, "ratio_tolerance": 0,
 "rotor_inner_diameter_mm": 79.4, "module_mm": 0.7, "planet_count": 3,
 "min_teeth": {"sun": 50, "planet_1": 20, "planet_2": 16},
 "load": {"output_torque_Nm": 120, "cycles": 1000000},
 "synthesis": {}})";

// Oracle: evaluate and strength of the same program, which know nothing of the search.
TEST(Synthesis, IsWhatStrengthAndActuatorTake) {
  const Workplace place;
  place.write("gears.json", kEightLines);
  const Outcome found = place.run({"gearbox", "optimize", "gears.json", "-o", "result.json"});
  EXPECT_EQ(found.exit_code, 0) << found.out << found.err;
  EXPECT_EQ(found.err, "");
  EXPECT_TRUE(found.out.starts_with("optimal: proved within ")) << found.out;
  EXPECT_NE(found.out.find("\nHeld fixed: one module for both layers"), std::string::npos);
  EXPECT_NE(found.out.find("/materials/steel"), std::string::npos);  // among what is assumed
  const json result = json::parse(place.text("result.json"));
  EXPECT_TRUE(io::conforms(result, "gearbox_result"));
  EXPECT_LE(result["bound"], result["objective"]);
  EXPECT_LE(result["gap"], 0.001 + 1e-12);
  const Outcome strength = place.run({"gearbox", "strength", "result.json"});
  EXPECT_EQ(strength.exit_code, 0) << strength.out << strength.err;
  EXPECT_NE(strength.out.find("120 Nm at the joint: borne"), std::string::npos) << strength.out;
  const Outcome verify = place.run({"gearbox", "verify", "result.json"});
  EXPECT_EQ(verify.exit_code, 2);
  EXPECT_EQ(verify.err,
            "result.json#/certificate: holds no claims: what a synthesis proves cannot be checked "
            "again yet\n");
}

TEST(Synthesis, EndsWithABoundAndRefusesWhatItDoesNotKnow) {
  const Workplace place;
  place.write("gears.json", kEightLines);
  const Outcome ended =
      place.run({"gearbox", "optimize", "gears.json", "--max-nodes", "10", "--json"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_EQ(json::parse(ended.out)["status"], "limit");
  EXPECT_EQ(place.run({"gearbox", "optimize", "gears.json", "--verify"}).exit_code, 2);
  EXPECT_EQ(place.run({"gearbox", "optimize", "gears.json", "--top", "2"}).exit_code, 2);
  json wrong = json::parse(kEightLines);
  wrong["synthesis"] = {{"min_profile_shift", 0.5}, {"max_profile_shift", 0.1}};
  place.write("gears.json", wrong.dump());
  EXPECT_EQ(place.run({"gearbox", "optimize", "gears.json"}).err,
            "gears.json#/synthesis/min_profile_shift: 0.5 is more than "
            "/synthesis/max_profile_shift, 0.1\n");
  wrong = json::parse(kEightLines);
  wrong.erase("load");
  place.write("gears.json", wrong.dump());
  EXPECT_EQ(place.run({"gearbox", "optimize", "gears.json"}).err,
            "gears.json#/load/output_torque_Nm: missing; synthesis needs it\n");
}

}  // namespace
}  // namespace torquewright::cli_test
