// SPDX-License-Identifier: Apache-2.0
// Effects that no other generator of logs draws, from a document through `identify simulate` and
// back by `identify`. Oracle: what was put in.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/cli/four_quadrants.hpp"
#include "tests/cli/spoilt_log.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test::effects {
namespace {

using nlohmann::json;

/// Standard errors of a fit to one fixed log.
constexpr double kErrors = 4.0;

const json kRig = {{"kind", "rig"},
                   {"version", 1},
                   {"name", "two encoders"},
                   {"columns",
                    {{"run", "run"},
                     {"t_s", "time_s"},
                     {"q_rad", "output_position_rad"},
                     {"motor_rad", "motor_position_rad"},
                     {"i_A", "motor_current_A"},
                     {"tau_Nm", "output_torque_Nm"}}},
                   {"load", {{"type", "dynamometer"}}},
                   {"holdout_runs", {"run_4"}}};

json with_effect(const std::string& name, const json& parameters) {
  return {{"effect", name}, {"parameters", parameters}, {"provenance", "assumed"}};
}

/// What is said of a log of an actuator with these effects, beside what is stated; `spoil`: what
/// the sensors do to the log.
json report_on(
    const json& effects, double speed_scale = 1.0,
    const std::function<void(SpoiltLog&)>& spoil = [](SpoiltLog&) {}) {
  const Workplace place;
  const std::string stated = in_repository("specs/log/bench_actuator.json");
  json truth = json::parse(text_of(stated));
  truth["effects"] = effects;
  place.write("truth.json", truth.dump());
  place.write("rig.json", kRig.dump());
  place.write("excitation.csv", four_quadrants(2400, speed_scale));
  const Outcome played = place.run(
      {"identify", "simulate", "truth.json", "--rig", "rig.json", "--excitation", "excitation.csv",
       "--noise", "output_torque_Nm=0.1", "--noise", "output_position_rad=0.0002", "--noise",
       "motor_position_rad=0.001", "--noise", "motor_current_A=0.05"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  SpoiltLog log(played.out);
  spoil(log);
  place.write("log.csv", log.text());
  const Outcome found =
      place.run({"identify", "log.csv", "--rig", "rig.json", "--actuator", stated, "--json"});
  return json::parse(found.out);
}

json added(
    const json& effects, double speed_scale = 1.0,
    const std::function<void(SpoiltLog&)>& spoil = [](SpoiltLog&) {}) {
  return report_on(effects, speed_scale, spoil)["effects_added"];
}

void expect_alone(const json& added, const std::string& name, const json& parameters) {
  ASSERT_EQ(added.size(), 1u) << added;
  EXPECT_EQ(added[0]["effect"], name);
  for (const auto& [key, value] : parameters.items()) {
    const double error = added[0]["standard_error"][key];
    EXPECT_NEAR(added[0]["parameters"][key].get<double>(), value.get<double>(), kErrors * error)
        << key;
    EXPECT_LT(error, 0.05 * std::abs(value.get<double>())) << key;
  }
}

TEST(IdentifyEffects, NamesEddyCurrentDragThatPassesItsPeak) {
  const json truth = {{"peak_Nm", 1.5}, {"critical_rad_s", 3.0}};
  expect_alone(added(json::array({with_effect("eddy_current_drag", truth)})), "eddy_current_drag",
               truth);
}

// At a sixtieth of the critical speed: 2 T_max / w_c, but for 0.03 %.
TEST(IdentifyEffects, CallsSlowEddyCurrentDragViscous) {
  const json truth = {{"peak_Nm", 3.0}, {"critical_rad_s", 40.0}};
  expect_alone(added(json::array({with_effect("eddy_current_drag", truth)}), 0.1),
               "viscous_friction", {{"viscous_Nm_s_rad", 0.15}});
}

TEST(IdentifyEffects, NamesAParallelSpring) {
  const json truth = {{"stiffness_Nm_rad", 0.8}, {"neutral_angle_rad", 0.4}};
  expect_alone(added(json::array({with_effect("parallel_spring", truth)})), "parallel_spring",
               truth);
}

// k q0 is one constant: a part of it may be an offset, or friction that differs by direction.
TEST(IdentifyEffects, SaysThatASpringsNeutralAngleHoldsOffsets) {
  const json effects = added(json::array(
      {with_effect("parallel_spring", {{"stiffness_Nm_rad", 0.8}, {"neutral_angle_rad", 0.4}})}));
  ASSERT_EQ(effects.size(), 1u);
  EXPECT_NE(effects[0]["evidence"].get<std::string>().find("offset of a sensor"),
            std::string::npos);
  EXPECT_EQ(effects[0]["certain"], true);
}

TEST(IdentifyEffects, NamesAnEndStop) {
  const json truth = {{"stiffness_Nm_rad", 5.0}, {"angle_rad", 0.5}};
  expect_alone(added(json::array({with_effect("upper_end_stop", truth)})), "upper_end_stop", truth);
}

// Both positions are logged: their difference shows the spring and the loop beside it.
// alone.
TEST(IdentifyEffects, NamesTheHysteresisOfAStrainWaveGearBesideItsSpring) {
  const json spring = {{"stiffness_Nm_rad", 1000.0}, {"damping_Nm_s_rad", 0.0}};
  const json loop = {{"amplitude_Nm", 4.0}, {"turn_rad", 0.004}};
  const json effects = added(json::array(
      {with_effect("torsional_compliance", spring), with_effect("strain_wave_hysteresis", loop)}));
  ASSERT_EQ(effects.size(), 2u) << effects;
  EXPECT_EQ(effects[0]["effect"], "torsional_compliance");
  EXPECT_EQ(effects[1]["effect"], "strain_wave_hysteresis");
  const auto expect_found = [](const json& found, const std::string& key, double truth) {
    EXPECT_NEAR(found["parameters"][key].get<double>(), truth,
                kErrors * found["standard_error"][key].get<double>())
        << found;
  };
  expect_found(effects[0], "stiffness_Nm_rad", 1000.0);
  expect_found(effects[1], "amplitude_Nm", 4.0);
  expect_found(effects[1], "turn_rad", 0.004);
}

// Dry friction that gives way before it slips is no hysteresis of the train: no twist shows it.
TEST(IdentifyEffects, CallsPreslidingFrictionNoHysteresisOfTheTrain) {
  const json effects = added(json::array(
      {with_effect("torsional_compliance",
                   {{"stiffness_Nm_rad", 1000.0}, {"damping_Nm_s_rad", 0.0}}),
       with_effect("presliding_friction", {{"coulomb_Nm", 1.0}, {"stiffness_Nm_rad", 100.0}})}));
  std::set<std::string> names;
  for (const json& each : effects) names.insert(each["effect"].get<std::string>());
  EXPECT_TRUE(names.contains("presliding_friction")) << effects;
  EXPECT_FALSE(names.contains("strain_wave_hysteresis")) << effects;
}

// Relaxed at the end of the travel, a weak spring explains a fifth of the noise nearly as well as a
// constant does: it has to explain more.
TEST(IdentifyEffects, CallsAConstantAnOffsetAndNoSpring) {
  const json report = report_on(json::array(), 1.0, [](SpoiltLog& log) {
    log.each("tau_Nm", [](double torque_Nm) { return torque_Nm + 0.02; });
  });
  const json& effects = report["effects_added"];
  ASSERT_EQ(effects.size(), 1u) << effects;
  EXPECT_EQ(effects[0]["effect"], "torque_offset");
  for (const json& group : report["confounded"]) EXPECT_EQ(group["exact"], true) << group;
}

/// A current sensor with these gains for positive and negative currents.
std::function<void(SpoiltLog&)> current_gains(double positive, double negative) {
  return [=](SpoiltLog& log) {
    log.each("i_A",
             [=](double current_A) { return current_A * (current_A > 0.0 ? positive : negative); });
  };
}

TEST(IdentifyEffects, NamesACurrentsGainThatIsWrongForOneSign) {
  expect_alone(added(json::array(), 1.0, current_gains(1.0, 0.9)), "current_gain_error",
               {{"gain_positive", 1.0}, {"gain_negative", 0.9}});
}

TEST(IdentifyEffects, CallsAGainOfBothSignsTheTorqueConstant) {
  expect_alone(added(json::array(), 1.0, current_gains(1.05, 1.05)), "torque_constant_error",
               {{"factor", 1.0 / 1.05}});
}

TEST(IdentifyEffects, NamesAnEncoderThatIsOffCentre) {
  const json effects = added(json::array(), 1.0, [](SpoiltLog& log) {
    log.each("q_rad", [](double q) {
      return q + 0.004 * std::sin(q + 0.7) + 0.002 * std::sin(2.0 * q - 1.0);
    });
  });
  ASSERT_EQ(effects.size(), 1u) << effects;
  EXPECT_EQ(effects[0]["effect"], "encoder_harmonics");
  const json& waves = effects[0]["parameters"]["harmonics"];
  ASSERT_EQ(waves.size(), 2u);
  const double amplitudes_rad[] = {0.004, 0.002}, phases_rad[] = {0.7, -1.0};
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(waves[k]["order"], k + 1);
    // The law asks by the measured angle, which is off by 0.006 rad at most.
    EXPECT_NEAR(waves[k]["amplitude_rad"].get<double>(), amplitudes_rad[k], 0.012 * 0.006);
    EXPECT_NEAR(waves[k]["phase_rad"].get<double>(), phases_rad[k], 0.012);
  }
}

}  // namespace
}  // namespace torquewright::cli_test::effects
