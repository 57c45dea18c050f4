// SPDX-License-Identifier: Apache-2.0
// Oracle: logs by closed form of a law of friction of which most is Coulomb's. The part alone is a
// wrong name, however small what it leaves is beside the torque that is used.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "actuator/motor/actuator.hpp"
#include "identification/answer/analysis.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::another_law_test {
namespace {

using made::Made;
using made::MadeBench;

constexpr double kSlow_rad_s = 0.4, kErrors = 3.0;

/// Coulomb's level, and `more` of it at rest.
EquationResult with_friction(double level_Nm, double more) {
  const MadeBench made;
  const Log log = made.log([=](const Made& at) {
    const double over = at.speed_rad_s / kSlow_rad_s;
    return -level_Nm * (1.0 + more * std::exp(-over * over)) * made::sign(at.speed_rad_s);
  });
  return analyse(made.rig, log, 0, {&made.actuator}, {}).front();
}

// 8 noise floors of friction on 4.8 Nm of torque, of which the rise towards rest is one and a half.
TEST(AnotherLaw, OfLessThanTheToleranceIsNamedWhereTheLogTellsIt) {
  const EquationResult found = with_friction(0.02, 1.0);
  ASSERT_EQ(found.added.size(), 1u);
  const FoundParameters& values = found.added[0].parameters;
  EXPECT_EQ(found.added[0].effect, "stribeck_friction");
  EXPECT_EQ(found.verdict, Verdict::kExplained);
  EXPECT_NEAR(values.value("coulomb_Nm", NAN), 0.02, kErrors * values.standard_error("coulomb_Nm"));
  EXPECT_NEAR(values.value("breakaway_Nm", NAN), 0.04,
              kErrors * values.standard_error("breakaway_Nm"));
  EXPECT_NEAR(values.value("stribeck_velocity_rad_s", NAN), kSlow_rad_s,
              kErrors * values.standard_error("stribeck_velocity_rad_s"));
}

// 3 floors, the rise half of one: what shows of it does not name it, and does not leave the other.
TEST(AnotherLaw, ThatLeavesLessBeyondChanceStandsBesideItsPart) {
  const EquationResult found = with_friction(0.008, 1.0);
  ASSERT_EQ(found.added.size(), 1u);
  EXPECT_FALSE(is_certain(found, "coulomb_friction"));
  const auto& groups = found.confounded;
  EXPECT_TRUE(std::any_of(groups.begin(), groups.end(), [](const Confounded& group) {
    const auto& names = group.effects;
    return std::find(names.begin(), names.end(), "stribeck_friction") != names.end();
  })) << found.added[0].effect;
}

TEST(AnotherLaw, StandsBesideNoFrictionThatIsCoulombs) {
  for (const double level_Nm : {0.008, 0.1}) {
    const EquationResult found = with_friction(level_Nm, 0.0);
    ASSERT_EQ(found.added.size(), 1u);
    EXPECT_TRUE(is_certain(found, "coulomb_friction")) << level_Nm;
    EXPECT_EQ(found.verdict, Verdict::kExplained);
  }
}

/// Coulomb friction of 0.05 Nm and a drag that grows with the power 0.6 of the speed.
EquationResult with_bent_drag(double coefficient_Nm) {
  const MadeBench made;
  const Log log = made.log([=](const Made& at) {
    const double drag_Nm = coefficient_Nm * std::pow(std::abs(at.speed_rad_s), 0.6);
    return -(0.05 + drag_Nm) * made::sign(at.speed_rad_s);
  });
  return analyse(made.rig, log, 0, {&made.actuator}, {}).front();
}

// A line through it leaves little of the whole, which names it all the same.
TEST(AnotherLaw, OfAPowerOfTheSpeedIsNoLine) {
  const EquationResult found = with_bent_drag(0.3);
  const auto bent = std::find_if(found.added.begin(), found.added.end(),
                                 [](const auto& each) { return each.effect == "power_law_drag"; });
  ASSERT_NE(bent, found.added.end());
  const FoundParameters& values = bent->parameters;
  EXPECT_NEAR(values.value("exponent", NAN), 0.6, kErrors * values.standard_error("exponent"));
  EXPECT_NEAR(values.value("coefficient_Nm", NAN), 0.3,
              kErrors * values.standard_error("coefficient_Nm"));
}

// Where line and power are as good, Coulomb's level goes with the law beside it.
TEST(AnotherLaw, AsGoodAsTheOneNamedIsInTheErrorsOfWhatStandsBesideIt) {
  for (const double coefficient_Nm : {0.02, 0.05, 0.1, 0.3}) {
    const EquationResult found = with_bent_drag(coefficient_Nm);
    for (const NamedEffect& each : found.added) {
      if (each.effect != "coulomb_friction") continue;
      EXPECT_NEAR(each.parameters.value("coulomb_Nm", NAN), 0.05,
                  kErrors * each.parameters.standard_error("coulomb_Nm"))
          << coefficient_Nm << ": " << each.evidence;
    }
  }
}

// Of 4.8 Nm rms the tolerance is 4.8 mNm: a ripple of 3.5 mNm rms is nothing, of 7.1 it is one.
TEST(Tolerance, IsOfWhatThereIsToExplainToo) {
  for (const double amplitude_Nm : {0.005, 0.01}) {
    const MadeBench made;
    const Log log = made.log(
        [=](const Made& at) { return amplitude_Nm * std::sin(3.0 * at.angle_rad); }, 0.001);
    const EquationResult found = analyse(made.rig, log, 0, {&made.actuator}, {}).front();
    EXPECT_EQ(found.verdict == Verdict::kNothingMissing, amplitude_Nm < 0.0048 * std::sqrt(2.0));
  }
}

/// The drive plays `current_A`, the sensor shows a tenth more than its torque.
EquationResult with_a_tenth_more(const std::function<double(std::size_t, double)>& current_A) {
  const MadeBench made;
  Log log = made.log([](const Made&) { return 0.0; });
  for (std::size_t r = 0; r < MadeBench::kRuns; ++r) {
    log.runs.change(r, [&](identification::Run& run) {
      Channels& channels = run.joints[0];
      for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        double& current = channels[Quantity::kMotorCurrent][k];
        double& torque_Nm = channels[Quantity::kOutputTorque][k];
        const double noise_Nm =
            torque_Nm - MadeBench::kRatio * MadeBench::kTorqueConstant_Nm_A * current;
        current = current_A(r, run.time_s[k]);
        torque_Nm = noise_Nm + 1.1 * MadeBench::kRatio * MadeBench::kTorqueConstant_Nm_A * current;
      }
    });
  }
  return analyse(made.rig, log, 0, {&made.actuator}, {}).front();
}

// Of 5 A either way no log says whether it is the constant, a saturation or a step by the sign.
TEST(OneLevel, OfTheCurrentLeavesNoTorqueConstantSure) {
  for (const double second_A : {5.0, 2.0}) {
    const EquationResult found = with_a_tenth_more([&](std::size_t run, double t) {
      const double size_A = std::fmod(t, 6.0) < 3.0 ? 5.0 : second_A;
      return std::copysign(size_A, std::sin(0.9 * t + static_cast<double>(run)));
    });
    ASSERT_EQ(found.added.size(), 1u);
    EXPECT_EQ(found.added[0].effect, "torque_constant_error");
    EXPECT_EQ(is_certain(found, "torque_constant_error"), second_A < 5.0) << second_A;
  }
}

}  // namespace
}  // namespace torquewright::identification::another_law_test
