// SPDX-License-Identifier: Apache-2.0
// Oracle: what the words mean. Sure is what no other may stand for and what makes the error of the
// runs that no fit saw no larger; one name that is not sure, and the log cannot tell.
#include "identification/findings/doubts.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "identification/findings/verdict.hpp"

namespace torquewright::identification {
namespace {

NamedEffect named(const char* effect, const char* parameter, double before, double after) {
  NamedEffect made;
  made.effect = effect;
  made.parameters.numbers = {{parameter, 0.1}};
  made.holdout_rms_before = before;
  made.holdout_rms_after = after;
  return made;
}

EquationResult with_two(double first_after, double second_after) {
  EquationResult result;
  result.unit = "A";
  result.is_noise_after = true;
  result.before = {0.4, 0.4};
  result.with_certain = {second_after, second_after};
  result.added = {
      named("viscous_friction", "viscous_Nm_s_rad", 0.4, first_after),
      named("load_dependent_friction", "driving_coefficient", first_after, second_after)};
  return result;
}

TEST(Doubts, AreNoneWhereEachNameLowersTheErrorAndNoneStandsForIt) {
  EquationResult result = with_two(0.3, 0.1);
  append_doubts(result);
  doubt_what_does_harm(result);
  EXPECT_EQ(certain_of(result).size(), 2u);
  EXPECT_EQ(verdict_of(result, true), Verdict::kExplained);
}

TEST(Doubts, GroupsOfEitherKindLeaveNoNameSure) {
  for (const bool exact : {false, true}) {
    EquationResult result = with_two(0.3, 0.1);
    result.confounded.push_back({{"torque_offset", "viscous_friction"}, exact, "", "another"});
    append_doubts(result);
    EXPECT_FALSE(is_certain(result, "viscous_friction"));
    EXPECT_TRUE(is_certain(result, "load_dependent_friction"));
    EXPECT_EQ(verdict_of(result, true), exact ? Verdict::kExplained : Verdict::kCannotTell);
  }
}

// Of 9.9 floors, whose square is that of noise 98 times, 97 are the model's.
TEST(Doubts, FallOnWhatTakesLessThanIsLeft) {
  const Left left{97.0, 1.0};
  EXPECT_NEAR(left.floors(), std::sqrt(98.0), 1e-12);
  EXPECT_NE(doubt_beside(left, 96.0, 3.0).find("9.9 noise floors"), std::string::npos);
  EXPECT_EQ(doubt_beside(left, 97.0, 3.0), "");
  EXPECT_EQ(doubt_beside({7.9, 1.0}, 1.0, 3.0), "");
  EXPECT_EQ(doubt_beside({7.9, 0.0}, 1.0, 3.0), "");  // no noise is no measure
}

// A law that leaves its own error along what it is a law of is another one; others may be there.
TEST(Doubts, FallOnLawsWhoseRestGoesAlongTheirOwnCoordinate) {
  const std::pair<const char*, const char*> kLaws[] = {
      {"viscous_friction", "output_velocity_rad_s"}, {"load_dependent_friction", "load_torque_Nm"}};
  for (const auto& [law, coordinate] : kLaws) {
    for (const double share : {0.49, 0.51}) {
      for (const double floors : {2.9, 3.1}) {
        EquationResult result = with_two(0.3, 0.1);
        result.added[0].effect = law;
        result.added[1].effect = "reflected_inertia";
        result.after = {0.1 * floors, 0.1};
        result.noise_floor_rms = 0.1;
        result.structure_after = {{coordinate, true, share, 0.0, {}, {}}};
        doubt_what_goes_along(3.0, result);
        EXPECT_EQ(is_certain(result, law), share < 0.5 || floors < 3.0) << law;
        EXPECT_TRUE(is_certain(result, "reflected_inertia"));
      }
    }
  }
}

// Cogging at a whole ratio is a ripple of the output: neither the region nor a prediction differs.
TEST(Doubts, AreNoneOfAnotherNameForTheSame) {
  EquationResult result = with_two(0.3, 0.1);
  result.confounded.push_back({{"viscous_friction", "another_name"}, true, "", ""});
  append_doubts(result);
  EXPECT_EQ(certain_of(result).size(), 2u);
}

TEST(Doubts, FallOnANameThatRaisesTheHeldOutError) {
  EquationResult result = with_two(0.41, 0.1);
  append_doubts(result);
  EXPECT_FALSE(is_certain(result, "viscous_friction"));
  EXPECT_NE(result.added[0].doubt.find("0.4 -> 0.41 A"), std::string::npos);
  EXPECT_TRUE(is_certain(result, "load_dependent_friction"));
  EXPECT_EQ(verdict_of(result, true), Verdict::kCannotTell);
}

TEST(Doubts, FallOnLawsOfWhichTheHeldOutRunsLeaveFarMore) {
  EquationResult result;
  result.noise_floor_rms = 0.01;
  result.added.emplace_back().effect = "coulomb_friction";
  result.after = {0.018, 0.05};
  doubt_what_fails_held_out(3.0, result);
  EXPECT_TRUE(is_certain(result, "coulomb_friction"));
  result.after = {0.018, 0.54};
  doubt_what_fails_held_out(3.0, result);
  EXPECT_FALSE(is_certain(result, "coulomb_friction"));
  EXPECT_FALSE(result.added.front().is_refuted);
}

TEST(Doubts, FallOnAllThatIsSureWhereTogetherItDoesHarm) {
  EquationResult result = with_two(0.3, 0.1);
  result.with_certain.holdout_rms = 0.5;
  doubt_what_does_harm(result);
  EXPECT_TRUE(certain_of(result).empty());
}

TEST(Doubts, FallOnWhatASimulationFollowsWorseThanByNoise) {
  const Errors stated{0.02, 0.02}, better{0.01, 0.01}, worse{0.03, 0.03};
  EquationResult result = with_two(0.3, 0.1);
  doubt_what_follows_worse(stated, better, 0.005, result);
  doubt_what_follows_worse(stated, worse, 0.02, result);  // noise does as much
  EXPECT_EQ(certain_of(result).size(), 2u);
  doubt_what_follows_worse(stated, worse, 0.005, result);
  EXPECT_TRUE(certain_of(result).empty());
}

// A torque constant by the voltage that the torque balance speaks against is the back-EMF's.
TEST(Doubts, FallOnWhatRaisesTheErrorOfAnotherEquation) {
  EquationResult balance = with_two(0.3, 0.1);
  balance.quantity = "output_torque_Nm";
  balance.noise_floor_rms = 0.01;
  EXPECT_FALSE(breaks_promise(balance.with_certain, {0.106, 0.106}, 0.01));
  EXPECT_TRUE(breaks_promise(balance.with_certain, {0.1, 0.108}, 0.01));
  EquationResult voltage;
  voltage.quantity = "winding_voltage_V";
  voltage.is_noise_after = true;
  voltage.added = {named("torque_constant_error", "factor", 0.4, 0.1),
                   named("viscous_friction", "viscous_Nm_s_rad", 0.4, 0.1)};
  doubt_what_harms_another(balance, {0.9, 0.9}, voltage);
  EXPECT_FALSE(is_certain(voltage, "torque_constant_error"));
  EXPECT_NE(voltage.added[0].doubt.find("in output_torque_Nm it raises the error, 0.1 -> 0.9"),
            std::string::npos);
  EXPECT_NE(voltage.added[0].doubt.find("/motor/back_emf_constant_V_s_rad"), std::string::npos);
  EXPECT_TRUE(is_certain(voltage, "viscous_friction"));  // which the balance names itself
  EXPECT_EQ(verdict_of(voltage, true), Verdict::kCannotTell);
}

// Times that are 2 % too long make accelerations 4 % too small, with any rotor.
TEST(Doubts, FallOnAnInertiaBesideAVelocityOfAnotherScale) {
  for (const double scale : {1.0004, 1.02}) {
    EquationResult velocity;
    velocity.added = {named("velocity_mismatch", "scale", 0.4, 0.1)};
    velocity.added[0].parameters.numbers = {{"scale", scale, 0.0002}};
    EquationResult torque = with_two(0.3, 0.1);
    torque.added.push_back(named("reflected_inertia", "inertia_kg_m2", 0.1, 0.05));
    doubt_what_goes_with_scale(velocity, torque);
    EXPECT_EQ(is_certain(torque, "reflected_inertia"), scale < 1.001);
    EXPECT_TRUE(is_certain(torque, "viscous_friction"));
  }
}

// N Kt g i = J a + b w: with g open, b and J are known over g only; a share of the load is not.
TEST(Doubts, FallOnTorquesBesideATorqueConstantInDoubt) {
  EquationResult result = with_two(0.3, 0.1);
  result.added.push_back(named("torque_constant_error", "factor", 0.1, 0.05));
  result.confounded.push_back({{"torque_constant_error", "load_inertia_error"}, true, "", ""});
  append_doubts(result);
  EXPECT_FALSE(is_certain(result, "viscous_friction"));
  EXPECT_TRUE(is_certain(result, "load_dependent_friction"));
}

/// Beside a torque sensor, at an output with 0.5 kg m^2 of which 0.4 stand before the gears.
EquationResult with_constant_and_inertia(double factor, double inertia_kg_m2) {
  EquationResult result;
  result.unit = "Nm";
  result.added = {named("torque_constant_error", "factor", 0.4, 0.2),
                  named("reflected_inertia", "inertia_kg_m2", 0.2, 0.1)};
  result.added[0].parameters.numbers = {{"factor", factor, 0.001}};
  result.added[1].parameters.numbers = {{"inertia_kg_m2", inertia_kg_m2, 0.002}};
  doubt_what_one_factor_explains(0.5, 0.4, result);
  return result;
}

// Oracle: tau g = g N Kt i - g J a of a sensor's gain; N r Kt i - r^2 J a of a ratio.
TEST(Doubts, FallOnAConstantAndAnInertiaThatOneFactorExplains) {
  const EquationResult gain = with_constant_and_inertia(1.1, 0.1 * 0.5 + 0.004);
  EXPECT_TRUE(certain_of(gain).empty());
  EXPECT_NE(gain.added[0].doubt.find("torque sensor's gain"), std::string::npos);
  const EquationResult ratio = with_constant_and_inertia(1.1, 0.21 * 0.4 - 0.004);
  EXPECT_TRUE(certain_of(ratio).empty());
  EXPECT_NE(ratio.added[0].doubt.find("gear ratio"), std::string::npos);
  EXPECT_EQ(certain_of(with_constant_and_inertia(1.1, 0.02)).size(), 2u);
  EXPECT_EQ(certain_of(with_constant_and_inertia(1.1, -0.05)).size(), 2u);
}

}  // namespace
}  // namespace torquewright::identification
