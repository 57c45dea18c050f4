// SPDX-License-Identifier: Apache-2.0
// Whole checks of motions whose every figure has a closed form, and every verdict and finding.
#include "actuator/check/check.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <thread>

#include "actuator/drive_check/check_report_spec.hpp"
#include "actuator/effects/library.hpp"
#include "tests/actuator/check/checked_joint.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kPi = std::numbers::pi;

using check_test::Checked;
using check_test::has_finding;
using check_test::motion;

double steady_5(double) { return 5.0; }
double turning_5(double t) { return 5.0 * t; }
double rest(double) { return 0.0; }
double ramp_40(double t) { return 40.0 * t; }

// Oracle: closed forms at constant 5 rad/s under a torque 40 t over 1 s, the cap being 30 Nm: of
// the 1001 samples those of t = 0.751 ... 1 are outside; rms 40/sqrt(3); current tau / 1 Nm/A;
// energy 5 * 20 + 0.5 * 1600 / 3 J. The trapezoidal rule's error is h^2/12 f'' = 1e-6 relative or
// less.
TEST(Check, FiguresOfARamp) {
  Checked checked;
  const CheckReport report = checked.report(motion(1000, nullptr, steady_5, ramp_40));
  const DriveReport& drive = report.drives.at(0);
  const CheckedInterpretation& interpretation = drive.interpretation;
  EXPECT_EQ(report.verdict, Verdict::kFail);
  EXPECT_EQ(drive.samples, 1001u);
  EXPECT_EQ(interpretation.clipped_samples, 250u);
  EXPECT_NEAR(interpretation.clipped_time_s, 0.2495, 1e-12);
  EXPECT_NEAR(interpretation.worst.time_s, 1.0, 0.0);
  EXPECT_NEAR(interpretation.worst.excess_Nm, 10.0, 1e-12);
  EXPECT_NEAR(*interpretation.worst.limit_Nm, 30.0, 1e-12);
  EXPECT_EQ(interpretation.worst.limiter, Limiter::kCurrent);
  EXPECT_NEAR(interpretation.margin_Nm, -10.0, 1e-12);
  EXPECT_FALSE(interpretation.speed_margin_rad_s.has_value());
  EXPECT_NEAR(*interpretation.voltage_margin_V, 48.0 - 0.5 * 40.0 - 5.0, 1e-12);
  EXPECT_NEAR(interpretation.peak_torque_Nm, 40.0, 0.0);
  EXPECT_NEAR(interpretation.rms_torque_Nm, 40.0 / std::sqrt(3.0), 1e-5);
  EXPECT_NEAR(interpretation.peak_current_A, 40.0, 1e-12);
  EXPECT_NEAR(interpretation.rms_current_A, 40.0 / std::sqrt(3.0), 1e-5);
  EXPECT_NEAR(interpretation.energy_drawn_J, 100.0 + 0.5 * 1600.0 / 3.0, 1e-3);
  EXPECT_EQ(interpretation.energy_returned_J, 0.0);
  EXPECT_TRUE(has_finding(report, "motor-operating-region", Severity::kViolation));
}

double braking(double) { return -4.0; }

// Oracle: closed form. -4 Nm at 5 rad/s return 20 W less 0.5 * 16 W of copper loss.
TEST(Check, CountsReturnedEnergy) {
  Checked checked;
  const CheckReport report = checked.report(motion(10, nullptr, steady_5, braking));
  EXPECT_NEAR(report.drives[0].interpretation.energy_returned_J, 12.0, 1e-12);
  EXPECT_EQ(report.drives[0].interpretation.energy_drawn_J, 0.0);
  EXPECT_EQ(report.verdict, Verdict::kPass);
  // The torque bounds are 30 above and below -30 Nm; the speed bound for -4 Nm is 48 + 2 rad/s.
  EXPECT_NEAR(report.drives[0].interpretation.margin_Nm, 26.0, 1e-9);
  EXPECT_NEAR(*report.drives[0].interpretation.speed_margin_rad_s, 45.0, 1e-6);
}

double at_the_cap(double) { return 30.0; }
double above_the_cap(double) { return 30.0 * (1.0 + 1e-8); }

TEST(Check, RoundingIsNoViolationAndMoreIs) {
  Checked checked;
  EXPECT_EQ(checked.report(motion(4, nullptr, rest, at_the_cap)).verdict, Verdict::kPass);
  EXPECT_EQ(checked.report(motion(4, nullptr, rest, above_the_cap)).verdict, Verdict::kFail);
}

double swing(double t) { return std::sin(2.0 * kPi * t); }
double swing_rate(double t) { return 2.0 * kPi * std::cos(2.0 * kPi * t); }
double swing_torque(double t) { return -29.8 * std::sin(2.0 * kPi * t); }

// Oracle: closed form. The rotor's torque is 0.01 kg m^2 times -(2 pi)^2 sin(2 pi t): 0.3948 Nm on
// top of 29.8 Nm, past the cap of 30 Nm. The slope's error is (2 pi h)^2 / 6 relative, 2e-5 at h =
// 1 ms.
TEST(Check, ReflectedInertiaDecidesAndIsNotDecided) {
  Checked checked;
  const std::string text = motion(1000, swing, swing_rate, swing_torque);
  const double peak_Nm = 29.8 + 0.01 * 4.0 * kPi * kPi;

  const CheckReport open = checked.report(text);
  EXPECT_EQ(open.verdict, Verdict::kUndecided);
  ASSERT_TRUE(open.drives[0].with_inertia.has_value());
  EXPECT_EQ(open.drives[0].interpretation.clipped_samples, 0u);
  EXPECT_NEAR(open.drives[0].with_inertia->peak_torque_Nm, peak_Nm, 1e-4);
  EXPECT_TRUE(has_finding(open, "reflected-inertia", Severity::kWarning));
  const auto json = check_report_json(open);
  EXPECT_EQ(json["verdict"], "undecided");
  EXPECT_EQ(json["joints"][0]["readings"][0]["verdict"], "pass");
  EXPECT_EQ(json["joints"][0]["readings"][1]["verdict"], "fail");

  checked.request().inertia = InertiaConvention::kIncluded;
  EXPECT_EQ(checked.report(text).verdict, Verdict::kPass);
  checked.request().inertia = InertiaConvention::kExcluded;
  const CheckReport added = checked.report(text);
  EXPECT_EQ(added.verdict, Verdict::kFail);
  EXPECT_FALSE(added.drives[0].with_inertia.has_value());
  EXPECT_NEAR(added.drives[0].interpretation.peak_torque_Nm, peak_Nm, 1e-4);
}

TEST(Check, BothReadingsAgreeingDecide) {
  Checked checked;
  EXPECT_EQ(checked.report(motion(100, swing, swing_rate, steady_5)).verdict, Verdict::kPass);
  EXPECT_EQ(checked.report(motion(100, nullptr, steady_5, ramp_40)).verdict, Verdict::kFail);
}

TEST(Check, WithoutRotorInertiaNothingIsOpen) {
  Actuator actuator = test::simple_actuator();
  actuator.motor.rotor_inertia_kg_m2 = 0.0;
  Checked checked(actuator);
  const CheckReport report = checked.report(motion(100, swing, swing_rate, swing_torque));
  EXPECT_EQ(report.verdict, Verdict::kPass);
  EXPECT_TRUE(has_finding(report, "reflected-inertia", Severity::kNote));
}

TEST(Check, WithoutTorqueIsUndecidedUnlessTheSpeedDecides) {
  Checked checked;
  const CheckReport open = checked.report(motion(10, nullptr, steady_5, nullptr));
  EXPECT_EQ(open.verdict, Verdict::kUndecided);
  EXPECT_TRUE(has_finding(open, "torque-missing", Severity::kWarning));
  EXPECT_TRUE(check_report_json(open)["joints"][0]["margin_Nm"].is_null());
  // The region ends at 48 + 15 rad/s, where the brake current meets its cap.
  checked.request().columns = {{"k_velocity_rad_s", "k", Quantity::kVelocity, 12.5}};
  EXPECT_EQ(checked.report(motion(10, nullptr, steady_5, nullptr)).verdict, Verdict::kUndecided);
  checked.request().columns = {{"k_velocity_rad_s", "k", Quantity::kVelocity, 12.7}};
  EXPECT_EQ(checked.report(motion(10, nullptr, steady_5, nullptr)).verdict, Verdict::kFail);
}

// Oracle: the velocity that the file holds in the other run; sin's slope to (2 pi h)^2 / 6.
TEST(Check, DifferentiatesThePosition) {
  Checked checked;
  const CheckReport given = checked.report(motion(1000, swing, swing_rate, steady_5));
  const CheckReport derived = checked.report(motion(1000, swing, nullptr, steady_5));
  EXPECT_FALSE(given.drives[0].is_speed_differentiated);
  EXPECT_TRUE(derived.drives[0].is_speed_differentiated);
  EXPECT_NEAR(derived.drives[0].peak_speed_rad_s, given.drives[0].peak_speed_rad_s, 1e-4);
  EXPECT_NEAR(derived.drives[0].interpretation.energy_drawn_J,
              given.drives[0].interpretation.energy_drawn_J, 1e-3);
  EXPECT_TRUE(has_finding(derived, "velocity-differentiated", Severity::kNote));
}

double past_a_turn(double t) { return 3.0 + 0.3 * std::sin(4.0 * t); }
double kept_in_a_turn(double t) { return std::remainder(past_a_turn(t), 2.0 * kPi); }

// Oracle: the same motion unwrapped. A jump that is no whole turn stays.
TEST(Check, LetsAWrappedAngleRunOn) {
  Checked checked;
  const CheckReport plain = checked.report(motion(400, past_a_turn, nullptr, steady_5));
  const CheckReport wrapped = checked.report(motion(400, kept_in_a_turn, nullptr, steady_5));
  EXPECT_NEAR(wrapped.drives[0].peak_speed_rad_s, plain.drives[0].peak_speed_rad_s, 1e-6);
  EXPECT_GT(wrapped.drives[0].unwrapped, 0u);
  EXPECT_TRUE(has_finding(wrapped, "angle-unwrapped", Severity::kNote));
  EXPECT_FALSE(has_finding(plain, "angle-unwrapped", Severity::kNote));
}

double in_degrees(double t) { return 180.0 / kPi * swing_rate(t); }

TEST(Check, WarnsOfDegreesUnderAHeaderInRad) {
  Checked checked;
  const CheckReport report = checked.report(motion(100, nullptr, in_degrees, steady_5));
  EXPECT_TRUE(has_finding(report, "speed-implausible", Severity::kWarning));
  const CheckReport plain = checked.report(motion(100, swing, swing_rate, steady_5));
  EXPECT_FALSE(has_finding(plain, "speed-implausible", Severity::kWarning));
  EXPECT_FALSE(has_finding(plain, "velocity-mismatch", Severity::kWarning));
}

double standing(double) { return 0.0; }

// A dead velocity is no speed within the region, and degrees are no radians.
TEST(Check, RefusesAVelocityThatIsNotTheRateOfThePosition) {
  Checked checked;
  EXPECT_NE(checked.refusal(motion(100, swing, standing, steady_5))
                .find("m.csv: the velocity of k is not the rate of its position: from t = "),
            std::string::npos);
  EXPECT_NE(checked.refusal(motion(100, standing, swing_rate, steady_5))
                .find("position changes by 0 rad"),
            std::string::npos);
  EXPECT_NE(checked.refusal(motion(100, swing, in_degrees, steady_5)).find("in degrees"),
            std::string::npos);
}

// Oracle: closed form. 10 Nm ask 10 A for ever: 25 K (1 + 0.004 d) settle at d = 27.8 K, where 0.5
// ohm are 0.5556: cold 10 Nm end at 48 - 5 = 43 rad/s, then at 42.44.
TEST(Check, HoldsAWarmWindingAgainstItsOwnRegion) {
  Actuator actuator = test::simple_actuator();
  actuator.thermal = Thermal{0.2, 0.3, 20.0, 200.0, 380.0, 300.0};
  actuator.motor.winding_temperature_K = 300.0;
  actuator.effects.push_back(
      {find_effect("winding_resistance_temperature"), {0.004}, {}, false, ""});
  Checked checked(actuator);
  const std::string text = motion(
      10, nullptr, [](double) { return 42.7; }, [](double) { return 10.0; });
  EXPECT_EQ(checked.report(text).verdict, Verdict::kPass);
  checked.request().runs = 100000;
  const CheckReport warm = checked.report(text);
  EXPECT_EQ(warm.verdict, Verdict::kFail);
  EXPECT_NEAR(*warm.drives[0].interpretation.voltage_margin_V,
              48.0 - 42.7 - 5.0 * (1.0 + 0.004 * 25.0 / 0.9), 1e-6);
  EXPECT_TRUE(has_finding(warm, "winding-temperature", Severity::kNote));
  checked.request().drives[0].conditions.winding_temperature_K = 300.0;  // who says so means it
  EXPECT_EQ(checked.report(text).verdict, Verdict::kPass);
}

/// The same drive with so little heat to fill that a run of a second warms it.
Actuator soon_warm() {
  Actuator actuator = test::simple_actuator();
  actuator.thermal = Thermal{0.2, 0.3, 0.5, 0.5, 380.0, 300.0};
  actuator.motor.winding_temperature_K = 300.0;
  actuator.effects.push_back(
      {find_effect("winding_resistance_temperature"), {0.004}, {}, false, ""});
  return actuator;
}

// What it does cold comes first.
TEST(Check, DoesNotHoldASingleRunAgainstTheHeatOfItsEnd) {
  Checked checked(soon_warm());
  const CheckReport report = checked.report(motion(
      10, nullptr, [](double) { return 42.7; }, [](double) { return 10.0; }));
  EXPECT_GT(report.drives[0].interpretation.winding->peak_K, 315.0);
  EXPECT_EQ(report.verdict, Verdict::kPass);
}

// After a pause of 100 s, many of its time constants, the last run begins as cold as the first.
TEST(Check, LeavesOpenWhatFailsOnlyWithinTheLastRun) {
  Checked checked(soon_warm());
  const std::string text = motion(
      10, nullptr, [](double) { return 42.7; }, [](double) { return 10.0; });
  checked.request().runs = 3;
  checked.request().pause_s = 100.0;
  const CheckReport paused = checked.report(text);
  EXPECT_EQ(paused.verdict, Verdict::kUndecided);
  EXPECT_NEAR(paused.drives[0].interpretation.winding->coldest_K, 300.0, 1e-6);
  EXPECT_TRUE(has_finding(paused, "winding-temperature", Severity::kWarning));
  EXPECT_FALSE(has_finding(paused, "motor-operating-region", Severity::kViolation));
  checked.request().pause_s = 0.0;
  EXPECT_EQ(checked.report(text).verdict, Verdict::kFail);
}

// Nothing is read from a pipe a second time, and nobody waits for it.
TEST(Check, SaysThatWhatComesThroughAPipeIsJudgedCold) {
  test::ScratchFolder folder;
  const Actuator actuator = soon_warm();
  const std::filesystem::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::string text = motion(
      10, nullptr, [](double) { return 42.7; }, [](double) { return 10.0; });
  std::thread writer([&] { std::ofstream(pipe) << text; });
  CheckRequest request;
  request.trajectory = pipe;
  request.drives = {{"k", &actuator, {}}};
  request.runs = 3;
  const CheckReport report = check(request);
  writer.join();
  EXPECT_EQ(report.verdict, Verdict::kUndecided);
  EXPECT_TRUE(has_finding(report, "winding-temperature", Severity::kWarning));
}

// A joint that fails cold keeps no other from its own heat, and none changes another's figures.
TEST(Check, JudgesEveryJointInItsOwnHeat) {
  const Actuator actuator = soon_warm();
  test::ScratchFolder folder;
  std::string text = "time_s,a_velocity_rad_s,a_torque_Nm,b_velocity_rad_s,b_torque_Nm\n";
  for (int i = 0; i <= 10; ++i) text += fmt::format("{},{},10,{},10\n", 0.1 * i, 42.7, 43.5);
  CheckRequest request;
  request.trajectory = folder.write("m.csv", text);
  request.drives = {{"a", &actuator, {}}, {"b", &actuator, {}}};
  request.runs = 1000;
  const CheckReport both = check(request);
  EXPECT_EQ(both.drives[0].verdict, Verdict::kFail);  // 42.7 of 43 rad/s cold, of 42.4 warm
  EXPECT_TRUE(both.drives[0].held_heat.has_value());
  EXPECT_EQ(both.drives[1].verdict, Verdict::kFail);
  EXPECT_FALSE(both.drives[1].held_heat.has_value());
}

// Oracle: closed form. The document's resistance is that of 300 K, and it begins at 390 K.
TEST(Check, HoldsASingleRunAgainstTheWindingThatItBeginsWith) {
  Actuator actuator = soon_warm();
  actuator.thermal->ambient_K = 390.0;
  actuator.thermal->winding_limit_K = 600.0;
  Checked checked(actuator);
  const CheckReport report = checked.report(motion(
      10, nullptr, [](double) { return 42.7; }, [](double) { return 10.0; }));
  // 0.5 (1 + 0.004 * 90) ohm at 10 A are 6.8 V beside 42.7 V.
  EXPECT_EQ(report.verdict, Verdict::kFail);
  EXPECT_NEAR(*report.drives[0].held_heat->shown_K, 390.0, 1e-9);
  EXPECT_NEAR(*report.drives[0].interpretation.voltage_margin_V, 48.0 - 42.7 - 6.8, 1e-9);
}

// Oracle: at 1 - 0.01 (T - 300) no flux is left from 400 K on; 30 A settle at 225 K above 300 K.
TEST(Check, IsOpenWhereTheDocumentsLawsEndBeforeTheHeat) {
  Actuator actuator = test::simple_actuator();
  actuator.thermal = Thermal{0.2, 0.3, 0.5, 0.5, 900.0, 300.0};
  actuator.motor.winding_temperature_K = 300.0;
  actuator.effects.push_back({find_effect("torque_constant_temperature"), {-0.01}, {}, false, ""});
  Checked checked(actuator);
  checked.request().runs = 1000;
  const CheckReport report = checked.report(motion(10, nullptr, rest, [](double) { return 25.0; }));
  EXPECT_EQ(report.verdict, Verdict::kUndecided);
  EXPECT_NE(report.drives[0].held_heat->objection, "");
}

// Two rows have one slope, one has none.
TEST(Check, RefusesRatesThatTooFewRowsHold) {
  Checked checked;
  checked.request().inertia = InertiaConvention::kIncluded;
  checked.request().window = {0.45, 0.55};
  EXPECT_NE(checked.refusal(motion(10, swing, nullptr, steady_5))
                .find("velocities cannot be had from fewer than 2 rows, and there is one"),
            std::string::npos);
  checked.request().inertia = InertiaConvention::kExcluded;
  EXPECT_NE(checked.refusal(motion(10, nullptr, swing_rate, steady_5)).find("fewer than 2 rows"),
            std::string::npos);
  checked.request().window = {0.45, 0.65};
  EXPECT_NE(checked.refusal(motion(10, swing, nullptr, steady_5)).find("fewer than 3 rows"),
            std::string::npos);
  checked.report(motion(10, nullptr, swing_rate, steady_5));
}

// What turns the rotor is part of one of two readings of a torque of which nothing is said.
TEST(Check, RefusesAnOpenReadingThatTooFewRowsHold) {
  Checked checked;
  const std::string text = "time_s,k_velocity_rad_s,k_torque_Nm\n0,5,4\n";
  EXPECT_NE(checked.refusal(text).find("say --torque-includes-inertia"), std::string::npos);
  checked.request().inertia = InertiaConvention::kIncluded;
  EXPECT_EQ(checked.report(text).verdict, Verdict::kPass);
}

// Oracle: an instant in a pause of any length is none of it.
TEST(Check, ARowWithoutDurationAsksNothingOfAPause) {
  Checked checked;
  checked.request().inertia = InertiaConvention::kIncluded;
  checked.request().pause_s = 1.0;
  const std::string text = "time_s,k_velocity_rad_s,k_torque_Nm\n0,5,4\n";
  EXPECT_EQ(checked.report(text).drives[0].interpretation.continuous_current.rms, 0.0);
  checked.request().pause_s = 0.0;
  EXPECT_NEAR(checked.report(text).drives[0].interpretation.continuous_current.rms, 4.0, 1e-12);
}

// Oracle: closed form. 20 Nm ask 20 A for ever; 0.5 ohm * 400 A^2 = 200 W (dc) over 0.5 K/W in all
// settle at 100 K above the ambient, if the resistance does not grow.
TEST(Check, WindingOverRepeatedRuns) {
  Actuator actuator = test::simple_actuator();
  actuator.thermal = Thermal{0.2, 0.3, 20.0, 200.0, 380.0, 300.0};
  actuator.motor.winding_temperature_K = 300.0;
  Effect constant{find_effect("winding_resistance_temperature"), {0.0}, {}, false, ""};
  actuator.effects.push_back(constant);
  Checked checked(actuator);
  const auto hold = [](double) { return 20.0; };
  const std::string text = motion(10, nullptr, rest, hold);
  const CheckReport once = checked.report(text);
  EXPECT_EQ(once.verdict, Verdict::kPass);
  EXPECT_TRUE(has_finding(once, "winding-temperature", Severity::kWarning));
  EXPECT_NEAR(*once.drives[0].interpretation.winding->steady_peak_K, 400.0, 1e-6);
  checked.request().runs = 100000;
  const CheckReport often = checked.report(text);
  EXPECT_EQ(often.verdict, Verdict::kFail);
  EXPECT_TRUE(has_finding(often, "winding-temperature", Severity::kViolation));
  EXPECT_NEAR(often.drives[0].interpretation.winding->peak_K, 400.0, 1e-6);
}

std::string ankle_motion() {
  return "time_s,p_position_rad,p_velocity_rad_s,p_torque_Nm,r_position_rad,r_velocity_rad_s,"
         "r_torque_Nm\n0,0.1,3,40,0.2,2,6\n0.1,0.4,3,40,0.4,2,6\n0.2,0.7,3,40,0.6,2,6\n";
}

// Oracle: closed form of the symmetric ankle (jacobian_test.cpp): 26 and 14 Nm at 4 and 2 rad/s;
// the energy of both is that of the joints, (3 * 40 + 2 * 6) W over 0.2 s, and their copper losses.
TEST(Check, TwoActuatorsMoveOneAnkle) {
  Checked checked;
  CheckRequest& request = checked.request();
  const CheckedDrive first = request.drives[0];
  request.drives = {first, first};
  request.drives[0].name = "a";
  request.drives[1].name = "b";
  ParallelDrive ankle{"ankle", {"p", "r"}, {"a", "b"}, {}, {}, {{1.0, 0.5, 1.0, -0.5}}};
  request.parallels = {ankle};
  const CheckReport report = checked.report(ankle_motion());
  EXPECT_EQ(report.verdict, Verdict::kPass);
  EXPECT_NEAR(report.drives[0].interpretation.peak_torque_Nm, 26.0, 1e-12);
  EXPECT_NEAR(report.drives[1].interpretation.peak_torque_Nm, 14.0, 1e-12);
  EXPECT_NEAR(report.drives[0].peak_speed_rad_s, 4.0, 1e-12);
  EXPECT_NEAR(report.drives[1].peak_speed_rad_s, 2.0, 1e-12);
  EXPECT_NEAR(report.drives[0].interpretation.energy_drawn_J +
                  report.drives[1].interpretation.energy_drawn_J,
              0.2 * (132.0 + 0.5 * (26.0 * 26.0 + 14.0 * 14.0)), 1e-10);

  ankle.first_rad = {0.0, 0.5};
  ankle.second_rad = {0.0, 1.0};
  ankle.matrices.assign(4, ankle.matrices.front());
  request.parallels = {ankle};
  EXPECT_EQ(
      checked.refusal(ankle_motion()),
      "m.csv: the table of the Jacobian \"ankle\" ends before the motion does: at 0.2 s, where "
      "p is at 0.7 rad and r at 0.6 rad");
  request.parallels[0].matrices.assign(4, {1.0, 1.0, 1.0, 1.0});
  EXPECT_EQ(
      checked.refusal(ankle_motion()),
      "m.csv: the Jacobian \"ankle\" is singular at 0 s, where p is at 0.1 rad and r at 0.2 rad");
  request.parallels[0].actuators = {"a", "other"};
  EXPECT_EQ(checked.refusal(ankle_motion()),
            "--jacobian: its actuator \"other\" has no document; say --joint other=FILE");
}

TEST(Check, RefusesTrajectoriesWithoutRows) {
  Checked checked;
  EXPECT_EQ(checked.refusal("time_s,k_velocity_rad_s\n"), "m.csv: holds a header and no rows");
  checked.request().window = {5.0, 6.0};
  EXPECT_EQ(checked.refusal(motion(10, nullptr, steady_5, nullptr)),
            "m.csv: no rows lie between --from 5 s and --until 6 s; the file's go from 0 s to 1 s");
  checked.request().window = {1.5, std::numeric_limits<double>::infinity()};
  EXPECT_EQ(checked.refusal(motion(10, nullptr, steady_5, nullptr)),
            "m.csv: no rows lie from --from 1.5 s on; the file's go from 0 s to 1 s");
}

TEST(Check, ASingleRowIsChecked) {
  Checked checked;
  checked.request().inertia = InertiaConvention::kIncluded;
  const CheckReport report = checked.report("time_s,k_velocity_rad_s,k_torque_Nm\n0,5,40\n");
  EXPECT_EQ(report.verdict, Verdict::kFail);
  EXPECT_EQ(report.drives[0].interpretation.rms_torque_Nm, 40.0);
  EXPECT_EQ(report.drives[0].interpretation.clipped_time_s, 0.0);
}

TEST(Check, TracesAreThinnedButKeepViolations) {
  Checked checked;
  checked.request().keep_traces = true;
  const CheckReport report = checked.report(motion(50000, turning_5, steady_5, ramp_40));
  ASSERT_EQ(report.traces.size(), 1u);
  EXPECT_LE(report.traces[0].size(), Trace::kMostPoints);
  EXPECT_GT(report.traces[0].size(), Trace::kMostPoints / 4);
  EXPECT_TRUE(report.traces[0].back().is_outside);
  // Oracle: every n-th sample, n a power of two: what is left inside lies at even steps from 0 on.
  std::vector<double> inside_s;
  for (const TracePoint& point : report.traces[0]) {
    if (!point.is_outside) inside_s.push_back(point.time_s);
  }
  const double step_s = 16.0 / 50000.0;  // 37501 samples inside, at most 4000 of them kept
  for (std::size_t i = 0; i < inside_s.size(); ++i) {
    ASSERT_NEAR(inside_s[i], static_cast<double>(i) * step_s, 1e-12);
  }
  for (std::size_t i = 1; i < report.traces[0].size(); ++i) {
    ASSERT_LE(report.traces[0][i - 1].time_s, report.traces[0][i].time_s);
  }
}

// The limit of what is checked, said once for each battery.
TEST(Findings, SayThatJointsOnOneBatteryWereCheckedAlone) {
  Actuator one = test::simple_actuator();
  one.battery = Battery{};
  one.battery->cell_open_circuit = {{1.0, 48.0}};
  Actuator same = one;
  Actuator other = one;
  other.battery->cell_resistance_ohm = 0.01;
  const Actuator none = test::simple_actuator();
  const std::string text = "time_s,a_velocity_rad_s,b_velocity_rad_s\n0,1,1\n1,1,1\n";
  const auto sentences = [&](const Actuator& of_a, const Actuator& of_b) {
    const test::ScratchFolder folder;
    CheckRequest request;
    request.drives = {{"a", &of_a, {}}, {"b", &of_b, {}}};
    request.trajectory = folder.write("m.csv", text);
    std::vector<std::string> found;
    for (const Finding& finding : check(request).findings) {
      if (finding.rule == "shared-battery") found.push_back(finding.sentence);
    }
    return found;
  };
  const std::vector<std::string> shared = sentences(one, same);
  ASSERT_EQ(shared.size(), 1u);
  EXPECT_TRUE(shared[0].starts_with("a, b state the same battery")) << shared[0];
  EXPECT_TRUE(sentences(one, other).empty());
  EXPECT_TRUE(sentences(none, none).empty());
}

}  // namespace
}  // namespace torquewright::actuator
