// SPDX-License-Identifier: Apache-2.0
// What a check does not reckon with, how much that may come to, and whether the verdict turns on
// it. Oracles: the effects' own laws on motions in closed form; the library's list.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "actuator/drive_check/left_out_sizes.hpp"
#include "tests/actuator/check/checked_joint.hpp"
#include "tests/actuator/effect_of_some_size.hpp"
#include "tests/actuator/example_actuator.hpp"

namespace torquewright::actuator {
namespace {

using check_test::Checked;
using check_test::has_finding;
using check_test::motion;

// From 0.5 to 2.5 rad at 2 rad/s, where the region ends at 30 Nm.
double slides_on(double t) { return 0.5 + 2.0 * t; }
double at_2(double) { return 2.0; }
double needs_20(double) { return 20.0; }
double needs_32(double) { return 32.0; }
double needs_ramp(double t) { return 20.0 * t; }

Actuator with(Effect effect) {
  Actuator actuator = test::simple_actuator();
  actuator.drive.peak_current_A = 30.0;
  actuator.effects = {std::move(effect)};
  return actuator;
}

CheckReport included(const Actuator& actuator, const std::string& text) {
  Checked checked(actuator);
  checked.request().inertia = InertiaConvention::kIncluded;
  return checked.report(text);
}

const LeftOutEffect& only(const CheckReport& report) {
  EXPECT_EQ(report.drives[0].effects_left_out.size(), 1u);
  return report.drives[0].effects_left_out.at(0);
}

// A spring of k is off by k |q - q0| at most: 2.5 k here. 10 Nm are left to the bound.
TEST(LeftOut, ASpringIsAsLargeAsItsLawAtTheMotionsAngles) {
  for (const double stiffness : {3.9, 4.1}) {
    const CheckReport report = included(with(effect("parallel_spring", {stiffness, 0.0})),
                                        motion(10, slides_on, at_2, needs_20));
    EXPECT_NEAR(*only(report).misjudged_Nm, 2.5 * stiffness, 1e-9);
    const bool is_open = stiffness > 4.0;
    EXPECT_EQ(report.verdict, is_open ? Verdict::kUndecided : Verdict::kPass);
    EXPECT_TRUE(
        has_finding(report, "effect-left-out", is_open ? Severity::kWarning : Severity::kNote));
  }
}

// What is missing to the bound may be the spring's: a failure is left open as a pass is.
TEST(LeftOut, AFailureByLessThanTheEffectIsLeftOpen) {
  for (const double stiffness : {0.7, 0.9}) {
    const CheckReport report = included(with(effect("parallel_spring", {stiffness, 0.0})),
                                        motion(10, slides_on, at_2, needs_32));
    const bool is_open = stiffness > 0.8;
    EXPECT_EQ(report.verdict, is_open ? Verdict::kUndecided : Verdict::kFail);
    EXPECT_EQ(has_finding(report, "motor-operating-region", Severity::kViolation), !is_open);
  }
}

TEST(LeftOut, WithoutPositionsASpringsSizeIsUnknown) {
  const CheckReport report =
      included(with(effect("parallel_spring", {1e-3, 0.0})), motion(10, nullptr, at_2, needs_20));
  EXPECT_FALSE(only(report).misjudged_Nm);
  EXPECT_EQ(report.verdict, Verdict::kUndecided);
}

// A ramp of 20 Nm/s lags by 20 Nm/s times the time constant; 10 Nm are left to the bound.
TEST(LeftOut, ALagIsAsLargeAsWhatIsMissingOfARamp) {
  for (const double lag_s : {0.4, 0.6}) {
    const CheckReport report =
        included(with(effect("torque_lag", {lag_s})), motion(10, slides_on, at_2, needs_ramp));
    EXPECT_NEAR(*only(report).misjudged_Nm, 20.0 * lag_s, 1e-9);
    EXPECT_EQ(report.verdict, lag_s > 0.5 ? Verdict::kUndecided : Verdict::kPass);
  }
}

// A motor that warms is judged at both ends of its heat; what is left out leaves both open, and the
// heat is not what decides.
TEST(LeftOut, IsNotTakenForADoubtOfTheHeat) {
  Actuator actuator = with(effect("parallel_spring", {100.0, 0.0}));
  actuator.thermal = Thermal{0.5, 1.0, 100.0, 500.0, 400.0};
  Checked checked(actuator);
  checked.request().inertia = InertiaConvention::kIncluded;
  checked.request().runs = 5;
  const CheckReport report = checked.report(motion(10, slides_on, at_2, needs_20));
  EXPECT_EQ(report.verdict, Verdict::kUndecided);
  ASSERT_TRUE(report.drives[0].held_heat);
  for (const Finding& finding : report.findings) {
    EXPECT_EQ(finding.sentence.find("fails at one of these temperatures"), std::string::npos);
  }
}

// A failure by what may last turns on no torque margin.
TEST(LeftOut, AFailureByHeatStays) {
  Actuator actuator = with(effect("parallel_spring", {100.0, 0.0}));
  actuator.drive.continuous_current_A = 1.0;
  EXPECT_EQ(included(actuator, motion(10, slides_on, at_2, needs_20)).verdict, Verdict::kFail);
}

// Every part holds an effect, or leaves it out by name; a replay holds them all. Without parameters
// that change something none has a size.
TEST(LeftOut, EveryEffectIsHeldOrNamed) {
  for (const EffectKind* kind : effect_library()) {
    Actuator actuator = test::simple_actuator();
    actuator.effects = {effect_of_some_size(*kind)};
    for (const Part part : {Part::kRegion, Part::kCheck, Part::kReplay}) {
      const std::vector<std::string> said = left_out(actuator, part);
      const bool is_named = std::any_of(said.begin(), said.end(), [&](const std::string& one) {
        return one.starts_with(std::string(kind->name) + ":");
      });
      EXPECT_EQ(is_named, !holds(part, actuator.effects[0])) << kind->name;
    }
    EXPECT_TRUE(holds(Part::kReplay, actuator.effects[0])) << kind->name;
    LeftOutSizes sizes(actuator, Part::kCheck);
    sizes.add({0.0, 0.1, 1.0, 5.0, 2.0});
    sizes.add({0.1, 0.4, 1.0, 7.0, 2.0});
    for (const LeftOutEffect& one : sizes.finish()) {
      ASSERT_TRUE(one.misjudged_Nm) << kind->name;
      EXPECT_GT(*one.misjudged_Nm, 0.0) << kind->name;
    }
    actuator.effects = {neutral(*kind)};
    LeftOutSizes nothing(actuator, Part::kCheck);
    nothing.add({0.0, 0.1, 1.0, 5.0, 2.0});
    nothing.add({0.1, 0.4, 1.0, 7.0, 2.0});
    for (const LeftOutEffect& one : nothing.finish()) {
      EXPECT_EQ(*one.misjudged_Nm, 0.0) << kind->name;
    }
  }
}

}  // namespace
}  // namespace torquewright::actuator
