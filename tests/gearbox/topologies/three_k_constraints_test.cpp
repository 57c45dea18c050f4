// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "gearbox/topologies/three_k.hpp"
#include "tests/gearbox/example_problem.hpp"

namespace torquewright::gearbox {
namespace {

ConstraintReport constraint_of(const Problem& problem, const std::vector<std::int64_t>& teeth,
                               std::int64_t planet_count, const std::string& name) {
  const DesignReport report =
      three_k::evaluate(problem, {teeth, planet_count, problem.module_mm.front()});
  const ConstraintReport* found = test::find(report, name);
  EXPECT_NE(found, nullptr) << name;
  return found ? *found : ConstraintReport{};
}

Problem buildable() {
  Problem problem = test::knee();
  problem.constraints = ConstraintSet::kBuildable;
  return problem;
}

TEST(CarrierClearance, SaysHowMuchIsToSpare) {
  const auto report = constraint_of(test::knee(), {44, 44, 32}, 4, "carrier_clearance");
  EXPECT_EQ(report.sentence,
            "carrier_clearance: 0.2618 rad from a planet's pitch circle to the middle between two "
            "planets, seen from the sun's axis; at least 0.26 rad are asked for: 0.0018 rad to "
            "spare.");
  EXPECT_EQ(report.key, "/min_carrier_clearance_rad");
  EXPECT_EQ(report.unit, "rad");
}

TEST(CarrierClearance, SaysWhatWouldMendIt) {
  Problem problem = test::knee();
  problem.min_carrier_clearance_rad = Rational(3, 10);
  // k = sin(pi/4 - 0.3) = 0.46656, k S/(1 - k) = 38.5; n = 3: pi/3 - pi/6 = 0.52 clears
  const auto report = constraint_of(problem, {44, 44, 32}, 4, "carrier_clearance");
  EXPECT_FALSE(report.satisfied);
  EXPECT_NE(report.sentence.find("needs n <= 3 or a planet of at most 38 teeth at this sun"),
            std::string::npos)
      << report.sentence;
}

TEST(CarrierClearance, DecidesDecimalsThatAgreeToEighteenDigits) {
  // The clearance of 44/44 with four planets is pi/12 = 0.26179938779914943653855...
  Problem problem = test::knee();
  const Rational unit("1/1000000000000000000");
  problem.min_carrier_clearance_rad = Rational("261799387799149436") * unit;
  EXPECT_TRUE(constraint_of(problem, {44, 44, 32}, 4, "carrier_clearance").satisfied);
  problem.min_carrier_clearance_rad = Rational("261799387799149437") * unit;
  EXPECT_FALSE(constraint_of(problem, {44, 44, 32}, 4, "carrier_clearance").satisfied);
}

TEST(CarrierClearance, IsExactlyZeroForSixPlanetsLikeTheSun) {
  Problem problem = test::knee();
  problem.min_carrier_clearance_rad = 0;
  const auto report = constraint_of(problem, {44, 44, 32}, 6, "carrier_clearance");
  EXPECT_EQ(report.value, 0.0);
  EXPECT_TRUE(report.satisfied);
}

TEST(NeighbourClearance, IsStrictAndExactForSixPlanets) {
  // n = 6: 2 a sin(30) - m (P + 2) = m ((S + P1)/2 - P - 2); S 48, P1 44: exactly 0.
  const auto touching = constraint_of(buildable(), {48, 44, 32}, 6, "neighbour_clearance.layer_1");
  EXPECT_EQ(touching.value, 0.0);
  EXPECT_FALSE(touching.satisfied);
  const auto apart = constraint_of(buildable(), {50, 44, 32}, 6, "neighbour_clearance.layer_1");
  EXPECT_EQ(apart.value, 0.6);
  EXPECT_TRUE(apart.satisfied);
}

TEST(Ratio, IsDecidedInFractions) {
  // 44/44/31: O = 119, i = 2 44 119/(44 13) = 238/13, 20 - 238/13 = 22/13, relative 11/130.
  Problem problem = test::knee();
  problem.ratio_tolerance = Rational(11, 130);
  EXPECT_TRUE(constraint_of(problem, {44, 44, 31}, 4, "ratio").satisfied);
  EXPECT_EQ(constraint_of(problem, {44, 44, 31}, 4, "ratio").margin, 0.0);
  problem.ratio_tolerance = Rational("10999999999999999999/130000000000000000000");
  EXPECT_FALSE(constraint_of(problem, {44, 44, 31}, 4, "ratio").satisfied);
  problem.target_ratio = -20;  // the sign counts
  problem.ratio_tolerance = 0;
  EXPECT_FALSE(constraint_of(problem, {44, 44, 32}, 4, "ratio").satisfied);
}

TEST(RotorBore, EndsAtTheLargestRing) {
  Problem problem = test::knee();  // 397/3 = 132.33 teeth
  EXPECT_TRUE(constraint_of(problem, {44, 44, 32}, 4, "rotor_bore").satisfied);
  const auto report = constraint_of(problem, {45, 44, 32}, 4, "rotor_bore");
  EXPECT_FALSE(report.satisfied);
  EXPECT_NE(report.sentence.find("at most 132 teeth"), std::string::npos) << report.sentence;
  problem.rotor_inner_diameter_mm = Rational(396, 5);  // 132 teeth exactly
  EXPECT_EQ(constraint_of(problem, {44, 44, 32}, 4, "rotor_bore").margin, 0.0);
  EXPECT_TRUE(constraint_of(problem, {44, 44, 32}, 4, "rotor_bore").satisfied);
}

TEST(IdenticalPlanets, SaysHowManyTypesAreNeeded) {
  const auto report = constraint_of(buildable(), {44, 42, 31, 128, 117}, 4, "identical_planets");
  EXPECT_FALSE(report.satisfied);
  EXPECT_EQ(report.value, 2);
  EXPECT_NE(report.sentence.find("2 planet part numbers"), std::string::npos) << report.sentence;
}

TEST(EqualSpacing, SaysWhichCountsDivide) {
  const auto report = constraint_of(test::knee(), {44, 44, 32}, 3, "equal_spacing");
  EXPECT_FALSE(report.satisfied);
  EXPECT_NE(report.sentence.find("divides 176 (2, 4, 8)"), std::string::npos) << report.sentence;
}

TEST(LimitsJustInsideAndOutside, OfWholeTeeth) {
  EXPECT_TRUE(constraint_of(buildable(), {44, 44, 18}, 4, "undercut.planet_2").satisfied);
  EXPECT_FALSE(constraint_of(buildable(), {44, 44, 17}, 4, "undercut.planet_2").satisfied);
  EXPECT_TRUE(constraint_of(buildable(), {44, 44, 39}, 4, "sun_under_layer_2").satisfied);
  EXPECT_FALSE(constraint_of(buildable(), {44, 44, 40}, 4, "sun_under_layer_2").satisfied);
  EXPECT_TRUE(constraint_of(buildable(), {44, 44, 40}, 4, "tooth_difference").satisfied);
  EXPECT_FALSE(constraint_of(buildable(), {44, 44, 41}, 4, "tooth_difference").satisfied);
  EXPECT_TRUE(constraint_of(test::knee(), {40, 44, 32}, 4, "min_teeth.sun").satisfied);
  EXPECT_FALSE(constraint_of(test::knee(), {39, 44, 32}, 4, "min_teeth.sun").satisfied);
  // ring tip: z > 2/(1 - cos 20) = 33.16
  EXPECT_TRUE(constraint_of(buildable(), {10, 12, 12}, 3, "ring_tip.output_ring").satisfied);
  EXPECT_FALSE(constraint_of(buildable(), {10, 12, 11}, 3, "ring_tip.output_ring").satisfied);
}

TEST(RingWall, IsExactAtTheLimit) {
  Problem problem = buildable();  // 0.6 (132 + 2.5) + 2 * 2.25 * 0.6 = 83.4
  problem.ring_outer_diameter_mm = Rational(417, 5);
  EXPECT_EQ(constraint_of(problem, {44, 44, 32}, 4, "ring_wall.fixed_ring").margin, 0.0);
  EXPECT_TRUE(constraint_of(problem, {44, 44, 32}, 4, "ring_wall.fixed_ring").satisfied);
  problem.ring_wall_mm = Rational(28, 20);
  EXPECT_FALSE(constraint_of(problem, {44, 44, 32}, 4, "ring_wall.fixed_ring").satisfied);
}

TEST(Interference, OfARingWithoutInvoluteSaysSo) {
  // z - 2 < z cos(20) below 33.16 teeth: O = 33
  for (const char* name :
       {"interference.involute.planet_2_output_ring", "interference.trochoid.planet_2_output_ring",
        "contact_ratio.planet_2_output_ring"}) {
    const auto report = constraint_of(buildable(), {10, 12, 11}, 3, name);
    EXPECT_FALSE(report.satisfied) << name;
    EXPECT_NE(report.sentence.find("does not exist"), std::string::npos) << report.sentence;
  }
}

TEST(Interference, OfAPlanetThatDoesNotFitSaysSo) {
  for (const char* name :
       {"interference.involute.planet_1_fixed_ring", "interference.trochoid.planet_1_fixed_ring",
        "contact_ratio.planet_1_fixed_ring"}) {
    const auto report = constraint_of(buildable(), {44, 80, 32, 60, 120}, 4, name);
    EXPECT_FALSE(report.satisfied) << name;
    EXPECT_NE(report.sentence.find("does not exist"), std::string::npos) << report.sentence;
  }
}

TEST(Sentences, SpeakOfOneToothAndOfExactMeetings) {
  EXPECT_EQ(
      constraint_of(test::knee(), {41, 44, 32}, 4, "min_teeth.sun").sentence,
      "min_teeth.sun: 41 teeth on this gear; at least 40 teeth are asked for: 1 tooth to spare.");
  EXPECT_EQ(
      constraint_of(test::knee(), {44, 44, 32}, 4, "ratio").sentence,
      "ratio: 20 turns of the sun per turn of the output; exactly 20 is asked for: met exactly.");
}

TEST(Coaxiality, SaysWhichShiftClosesTheGap) {
  // S + P1 = 88 between the centres; F = 133 is one tooth too many: with z2 - z1 = 89 the working
  // angle is acos(89 cos(20)/88) = 18.1..., the shift 89 (inv - inv 20)/(2 tan 20) is negative.
  const auto report = constraint_of(test::knee(), {44, 44, 32, 133, 120}, 4, "coaxial.fixed_ring");
  EXPECT_FALSE(report.satisfied);
  EXPECT_EQ(report.value, 1);
  EXPECT_NE(report.sentence.find("needs the ring shifted by -0.4"), std::string::npos)
      << report.sentence;
  EXPECT_TRUE(
      constraint_of(test::knee(), {44, 44, 32, 133, 120}, 4, "coaxial.output_ring").satisfied);
  const auto far = constraint_of(test::knee(), {44, 44, 32, 300, 120}, 4, "coaxial.fixed_ring");
  EXPECT_NE(far.sentence.find("no profile shift closes it"), std::string::npos) << far.sentence;
}

}  // namespace
}  // namespace torquewright::gearbox
