// SPDX-License-Identifier: Apache-2.0
// What a report says of a drive besides its torques, and the words of its findings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "actuator/check/check.hpp"
#include "actuator/drive_check/region_lookup.hpp"
#include "actuator/effects/library.hpp"
#include "actuator/region/torque_at.hpp"
#include "tests/actuator/check/checked_joint.hpp"

namespace torquewright::actuator {
namespace {

using check_test::Checked;
using check_test::motion;

double back_7(double) { return -7.0; }
double slow(double) { return 1.0; }
double angle(double t) { return std::sin(6.0 * t); }
double rate(double t) { return 6.0 * std::cos(6.0 * t); }
double against(double t) { return -rate(t); }
double rate_in_degrees(double t) { return rate(t) * 180.0 / std::numbers::pi; }

/// The only finding with that rule; an empty one: there is none.
Finding finding_of(const CheckReport& report, const std::string& rule) {
  for (const Finding& finding : report.findings) {
    if (finding.rule == rule) return finding;
  }
  return {};
}

/// The sentence of the only finding with that rule; empty: there is none.
std::string sentence_of(const CheckReport& report, const std::string& rule) {
  std::string found;
  for (const Finding& finding : report.findings) {
    if (finding.rule == rule) found += finding.sentence;
  }
  return found;
}

bool says(const std::string& sentence, const std::string& words) {
  return sentence.find(words) != std::string::npos;
}

TEST(DriveFigures, PeakSpeedIsThatOfEitherDirection) {
  Checked checked;
  EXPECT_EQ(checked.report(motion(4, nullptr, back_7, slow)).drives[0].peak_speed_rad_s, 7.0);
}

// Oracle: sums by hand. N^2 J = 0.01 kg m^2, the effect's own 0.03, the gears' 0.002.
TEST(DriveFigures, ArmatureHoldsAStatedReflectedInertia) {
  Actuator actuator = test::simple_actuator();
  EXPECT_NEAR(reflected_inertia_kg_m2(actuator), 0.01, 1e-15);
  actuator.effects.push_back({find_effect("reflected_inertia"), {0.03}, {}, false, ""});
  EXPECT_NEAR(reflected_inertia_kg_m2(actuator), 0.04, 1e-15);
  actuator.transmission.inertia_kg_m2 = 0.002;
  EXPECT_NEAR(reflected_inertia_kg_m2(actuator), 0.042, 1e-15);
}

TEST(DriveFigures, ListEffectsThatNoRegionHolds) {
  Actuator actuator = test::simple_actuator();
  const EffectKind* kind = find_effect("backlash");
  actuator.effects.push_back(
      {kind, std::vector<double>(kind->parameters.size(), 0.01), {}, false, ""});
  Checked checked(actuator);
  const auto left_out = checked.report(motion(4, nullptr, slow, slow)).drives[0].left_out;
  EXPECT_TRUE(std::any_of(left_out.begin(), left_out.end(),
                          [](const std::string& each) { return says(each, "backlash"); }));
}

// Oracle: the region of the simple actuator ends at 48 + 15 rad/s; of the speeds beyond, that at
// 0.5 s is the fastest.
TEST(DriveFigures, WithoutTorqueTheFastestImpossibleSpeedIsNamed) {
  Checked checked;
  const CheckReport report =
      checked.report("time_s,k_velocity_rad_s\n0,5\n0.25,70\n0.5,-90\n0.75,80\n1,5\n");
  const DriveReport& drive = report.drives[0];
  EXPECT_EQ(drive.impossible_speeds, 3u);
  EXPECT_EQ(*drive.limiting_speed_rad_s, -90.0);
  EXPECT_EQ(*drive.limiting_time_s, 0.5);
  EXPECT_TRUE(says(sentence_of(report, "motor-operating-region"), "-90 rad/s (t = 0.5 s)"));
  EXPECT_EQ(sentence_of(report, "torque-missing"), "");
  const Finding finding = finding_of(report, "motor-operating-region");
  EXPECT_EQ(finding.severity, Severity::kViolation);
  EXPECT_EQ(finding.value, -90.0);
  EXPECT_EQ(finding.time_s, 0.5);
  EXPECT_EQ(finding.unit, "rad/s");
}

// Oracle: the order of the severities, the worst first; the joint that passes was asked for first.
TEST(Findings, StandWorstFirst) {
  Checked checked;
  CheckRequest& request = checked.request();
  request.drives.push_back(request.drives[0]);
  request.drives[1].name = "j";
  const CheckReport report = checked.report(
      "time_s,k_velocity_rad_s,k_torque_Nm,j_velocity_rad_s,j_torque_Nm\n0,5,1,5,40\n1,5,1,5,40\n");
  ASSERT_GT(report.findings.size(), 1u);
  EXPECT_EQ(report.findings.front().joint, "j");
  EXPECT_EQ(report.findings.front().severity, Severity::kViolation);
  EXPECT_EQ(report.findings.back().severity, Severity::kNote);
}

// Beyond the region's end its reason is the one of the region there, asked at that speed.
TEST(DriveFigures, AnEmptyRegionSaysItsOwnReason) {
  Actuator actuator = test::simple_actuator();
  const double speed_rad_s = 70.0;
  const JointRange truth = RegionLookup(actuator, {}).exact(speed_rad_s);
  ASSERT_TRUE(truth.is_empty);
  ASSERT_NE(truth.why_empty, WorstSample{}.limiter);  // else nothing would be seen
  Checked checked(actuator);
  const auto fast = [](double) { return 70.0; };
  const CheckReport report = checked.report(motion(4, nullptr, fast, slow));
  EXPECT_EQ(report.drives[0].interpretation.worst.limiter, truth.why_empty);
}

// A factor near 1 is no mistake: what is left is the offset, or nothing that can be named.
TEST(Findings, NameTheOffsetOfAVelocity) {
  Checked checked;
  const auto refusal = [&](double (*velocity)(double)) {
    return checked.refusal(motion(200, angle, velocity, slow));
  };
  const std::string above = refusal([](double t) { return rate(t) + 2.0; });
  EXPECT_TRUE(says(above, "it seems to be d(position)/dt and an offset of 2")) << above;
  EXPECT_FALSE(says(above, "times d(position)/dt")) << above;
  const std::string below = refusal([](double t) { return rate(t) - 2.0; });
  EXPECT_TRUE(says(below, "an offset of -")) << below;
  const std::string dead = refusal([](double) { return 0.0; });
  EXPECT_TRUE(says(dead, "may be dead")) << dead;
}

// Oracle: which mistake was made; the sentence names that one and no other.
TEST(Findings, NameTheMistakeThatAVelocityLooksLike) {
  Checked checked;
  const auto refusal = [&](double (*velocity)(double)) {
    return checked.refusal(motion(200, angle, velocity, slow));
  };
  const std::string signs = refusal(against);
  EXPECT_TRUE(says(signs, "it is -1 times d(position)/dt; their signs differ. Mend")) << signs;
  EXPECT_FALSE(says(signs, "degrees")) << signs;
  const std::string degrees = refusal(rate_in_degrees);
  EXPECT_TRUE(says(degrees, "it seems to be in degrees, the position in rad")) << degrees;
  EXPECT_FALSE(says(degrees, "signs")) << degrees;
  EXPECT_TRUE(says(refusal([](double t) { return 30.0 / std::numbers::pi * rate(t); }),
                   "in revolutions per minute"));
  EXPECT_TRUE(says(refusal([](double t) { return 0.5 / std::numbers::pi * rate(t); }),
                   "in turns, the position in rad"));
  EXPECT_TRUE(says(refusal([](double t) { return 0.5 * rate(t); }), "it is 0.5"));
  const std::string stated_wrongly =
      refusal([](double t) { return std::numbers::pi / 180.0 * rate(t); });
  EXPECT_TRUE(says(stated_wrongly, "the position seems to be in degrees")) << stated_wrongly;
  EXPECT_TRUE(says(stated_wrongly, "the velocity is in rad/s and was taken for deg/s"));
  const auto scaled = [](double t) { return 0.75 * rate(t); };
  const std::string warning =
      sentence_of(checked.report(motion(200, angle, scaled, slow)), "velocity-mismatch");
  EXPECT_TRUE(says(warning, "0.75")) << warning;
  EXPECT_FALSE(says(warning, ";")) << warning;
}

// Oracle: 20 rad/s in degrees is 1146, which as rad/s is 24 times the no-load speed of 48; 1e5
// rad/s would be absurd in degrees per second too.
TEST(Findings, GuessDegreesOnlyWhereDegreesWouldBePlausible) {
  Checked checked;
  const auto degrees = [](double) { return 20.0 * 180.0 / std::numbers::pi; };
  const std::string hint =
      sentence_of(checked.report(motion(4, nullptr, degrees, slow)), "speed-implausible");
  EXPECT_TRUE(says(hint, "degrees under a header in rad?")) << hint;
  const auto absurd = [](double) { return 1e5; };
  const std::string none =
      sentence_of(checked.report(motion(4, nullptr, absurd, slow)), "speed-implausible");
  EXPECT_NE(none, "");
  EXPECT_FALSE(says(none, "degrees")) << none;
}

// Oracle: after a pause of many time constants the winding is at the ambient again: however often
// the motion is repeated, its peak is that of the first run.
TEST(WindingReport, StartsColdAfterALongPause) {
  Actuator actuator = test::simple_actuator();
  actuator.thermal = Thermal{0.2, 0.3, 20.0, 200.0, 380.0, 300.0};
  actuator.motor.winding_temperature_K = 300.0;
  Checked checked(actuator);
  const auto rest = [](double) { return 0.0; };
  const auto hold = [](double) { return 20.0; };
  const std::string text = motion(10, nullptr, rest, hold);
  const WindingReport once = *checked.report(text).drives[0].interpretation.winding;
  checked.request().runs = 7;
  checked.request().pause_s = 1e5;  // the slowest time constant is near 100 s
  const WindingReport often = *checked.report(text).drives[0].interpretation.winding;
  EXPECT_EQ(once.runs, 1u);
  EXPECT_EQ(often.runs, 7u);
  EXPECT_GT(once.peak_K, 305.0);
  EXPECT_NEAR(often.peak_K, once.peak_K, 1e-9);
  EXPECT_NEAR(often.steady_peak_K.value(), once.peak_K, 1e-9);
}

// Oracle: 10 steps of 0.1 s and one that is `gap` long, against their mean of 0.1 s.
TEST(DriveFigures, AGapInTimeIsSaid) {
  for (const double gap_s : {1.9, 2.1}) {
    std::string text = "time_s,k_velocity_rad_s,k_torque_Nm";
    for (int i = 0; i <= 10; ++i) text += fmt::format("\n{},5,1", 0.1 * i);
    text += fmt::format("\n{},5,1\n", 1.0 + gap_s);
    const Finding gap = finding_of(Checked().report(text), "time-gap");
    EXPECT_EQ(gap.time_s.has_value(), gap_s > 2.0);
    if (!gap.time_s) continue;
    EXPECT_EQ(gap.severity, Severity::kWarning);
    EXPECT_NEAR(*gap.time_s, 1.0, 1e-12);
    EXPECT_NEAR(*gap.value, gap_s, 1e-12);
    EXPECT_NEAR(*gap.limit, 2.0, 1e-12);
  }
}

// Slopes of positions run across a gap as of the same motion, and after 0.1 s nobody knows which.
TEST(DriveFigures, NoVelocityIsDifferentiatedAcrossAGap) {
  for (const double gap_s : {0.09, 0.11}) {
    std::string text = "time_s,k_position_rad,k_torque_Nm";
    for (int i = 0; i <= 100; ++i) text += fmt::format("\n{},{},1", 1e-3 * i, 5e-3 * i);
    text += fmt::format("\n{},{},1\n", 0.1 + gap_s, 0.5 + 5 * gap_s);
    std::string refused;
    try {
      (void)Checked().report(text);
    } catch (const io::SpecError& error) {
      refused = error.what();
    }
    EXPECT_EQ(refused != "", gap_s > 0.1) << refused;
    if (refused.empty()) continue;
    EXPECT_NE(refused.find("no samples for 0.11 s from t = 0.1 s on"), std::string::npos);
    EXPECT_NE(refused.find("with --until 0.1 and with --from 0.21"), std::string::npos) << refused;
  }
}

}  // namespace
}  // namespace torquewright::actuator
