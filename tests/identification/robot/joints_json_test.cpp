// SPDX-License-Identifier: Apache-2.0
// What was found, joint by joint. Oracle: the keys of the contract's report of a robot.
#include <gtest/gtest.h>

#include "identification/answer/report_spec.hpp"

namespace torquewright::identification {
namespace {

NamedEffect named(const std::string& effect, EffectFamily family) {
  NamedEffect one;
  one.effect = effect;
  one.family = family;
  return one;
}

EquationResult equation_of(const std::string& joint, Verdict verdict) {
  EquationResult equation;
  equation.joint = joint;
  equation.quantity = "commanded_torque_Nm";
  equation.unit = "Nm";
  equation.verdict = verdict;
  return equation;
}

TEST(JointsJson, HoldsEachJointAndTheLoad) {
  Identification found;
  EquationResult hip = equation_of("hip", Verdict::kExplained);
  hip.added = {named("coulomb_friction", EffectFamily::kActuator)};
  EquationResult knee = equation_of("knee", Verdict::kCannotTell);
  knee.added = {named("load_mass_error", EffectFamily::kRig)};
  knee.confounded = {{{"load_mass_error", "torque_constant_error"}, false, "a known mass", ""}};
  found.equations = {hip, knee};
  const nlohmann::ordered_json report = identification_report_json(found);
  ASSERT_EQ(report["joints"].size(), 2u);
  EXPECT_EQ(report["joints"][0]["joint"], "hip");
  EXPECT_EQ(report["joints"][0]["verdict"], "explained");
  ASSERT_EQ(report["joints"][0]["effects_added"].size(), 1u);
  EXPECT_EQ(report["joints"][0]["effects_added"][0]["effect"], "coulomb_friction");
  EXPECT_TRUE(report["joints"][0]["confounded"].empty());
  EXPECT_TRUE(report["joints"][0]["unexplained"].empty());
  EXPECT_EQ(report["joints"][1]["verdict"], "cannot_tell");
  // What is of the load is not the knee's.
  EXPECT_TRUE(report["joints"][1]["effects_added"].empty());
  EXPECT_EQ(report["joints"][1]["confounded"].size(), 1u);
  ASSERT_EQ(report["load"]["effects_added"].size(), 1u);
  EXPECT_EQ(report["load"]["effects_added"][0]["joint"], "knee");
  EXPECT_EQ(report["load"]["confounded"].size(), 1u);
}

TEST(JointsJson, LeavesTheReportOfABenchAsItWas) {
  Identification found;
  found.equations = {equation_of("", Verdict::kNothingMissing)};
  const nlohmann::ordered_json report = identification_report_json(found);
  EXPECT_FALSE(report.contains("joints"));
  EXPECT_FALSE(report.contains("load"));
}

}  // namespace
}  // namespace torquewright::identification
