// SPDX-License-Identifier: Apache-2.0
// What the rig may stand for is not called the actuator's. Oracle: closed forms in which the
// actuator is as stated and one value of the rig is not, or a sensor is off.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test::rivals {
namespace {

using nlohmann::json;

constexpr double kRate_Hz = 200.0;
constexpr int kRows = 2000;
constexpr int kRuns = 4;

/// N Kt = 0.9 Nm/A, without friction and next to no rotor.
const json kDrive = {
    {"kind", "actuator"},
    {"version", 1},
    {"name", "drive"},
    {"motor",
     {{"torque_constant_Nm_A", 0.1},
      {"torque_constant_convention", "dc"},
      {"resistance_ohm", 0.4},
      {"resistance_convention", "dc"},
      {"rotor_inertia_kg_m2", 1e-12}}},
    {"drive", {{"bus_voltage_V", 48}, {"peak_current_A", 60}}},
    {"gearbox", {{"ratio", 9}, {"forward_efficiency", 1}, {"backward_efficiency", 1}}}};
constexpr double kNewtonMetresPerAmpere = 0.9;

/// q, its speed and its acceleration: two sines, of other phases in each run.
double wave(int run, double t, int derivative) {
  double sum = 0.0;
  const double terms[2][3] = {{1.1, 1.9, 0.9}, {0.35, 6.1, 2.3}};
  for (const auto& [amplitude_rad, frequency_rad_s, phase] : terms) {
    sum +=
        amplitude_rad * std::pow(frequency_rad_s, derivative) *
        std::sin(frequency_rad_s * t + phase * (run + 1) + derivative * 0.5 * 3.14159265358979324);
  }
  return sum;
}

/// t, q, i, and tau where a sensor measures it, from laws of a run and a time.
template <typename Current, typename Torque>
std::string log_of(const Current& current_A, const Torque& torque_Nm, double sigma_A) {
  std::mt19937_64 random(29);
  std::normal_distribution<double> noise;
  std::string text = "run,t_s,q_rad,i_A,tau_Nm\n";
  for (int run = 0; run < kRuns; ++run) {
    for (int row = 0; row < kRows; ++row) {
      const double t = row / kRate_Hz;
      text += fmt::format(
          "r{},{:.6f},{:.7f},{:.6f},{:.6f}\n", run, t, wave(run, t, 0) + 1e-5 * noise(random),
          current_A(run, t) + sigma_A * noise(random), torque_Nm(run, t) + 0.02 * noise(random));
    }
  }
  return text;
}

json rig_of(const json& load, const std::vector<std::string>& uncertain = {}) {
  const bool has_sensor = load["type"] == "dynamometer";
  json rig = {{"kind", "rig"},
              {"version", 1},
              {"columns",
               {{"run", "run"},
                {"t_s", "time_s"},
                {"q_rad", "output_position_rad"},
                {"i_A", "motor_current_A"}}},
              {"load", load},
              {"holdout_runs", {"r3"}}};
  if (has_sensor) rig["columns"]["tau_Nm"] = "output_torque_Nm";
  if (!has_sensor) rig["ignore"] = {"tau_Nm"};
  if (!uncertain.empty()) rig["uncertain"] = uncertain;
  return rig;
}

struct Answer {
  int exit_code;
  json report;
  bool has_refined;
  std::string text;
};

Answer answer_to(const std::string& log, const json& rig) {
  const Workplace place;
  place.write("log.csv", log);
  place.write("rig.json", rig.dump());
  place.write("drive.json", kDrive.dump());
  const Outcome outcome =
      place.run({"identify", "log.csv", "--rig", "rig.json", "--actuator", "drive.json",
                 "--refined", "refined.json", "-o", "report.json"});
  return {outcome.exit_code, json::parse(place.text("report.json")), place.has("refined.json"),
          outcome.out};
}

bool stands_in_a_group(const json& report, const std::string& first, const std::string& second) {
  return std::any_of(report["confounded"].begin(), report["confounded"].end(),
                     [&](const json& group) {
                       const json& names = group["effects"];
                       return std::find(names.begin(), names.end(), first) != names.end() &&
                              std::find(names.begin(), names.end(), second) != names.end();
                     });
}

void expect_not_sure(const Answer& answer) {
  EXPECT_EQ(answer.report["verdict"], "explained") << answer.text;  // what is left is noise
  EXPECT_NE(answer.text.find("No log of such a rig tells "), std::string::npos) << answer.text;
  EXPECT_EQ(answer.text.find("Missing from the model: "), std::string::npos) << answer.text;
  EXPECT_FALSE(answer.has_refined);
  ASSERT_FALSE(answer.report["effects_added"].empty());
  for (const json& each : answer.report["effects_added"]) EXPECT_EQ(each["certain"], false) << each;
}

double no_sensor(int, double) { return 0.0; }

std::string wheel_log(double inertia_kg_m2) {
  return log_of(
      [=](int run, double t) { return inertia_kg_m2 * wave(run, t, 2) / kNewtonMetresPerAmpere; },
      no_sensor, 0.02);
}

json wheel(double inertia_kg_m2) { return {{"type", "free"}, {"inertia_kg_m2", inertia_kg_m2}}; }

// Lighter and heavier than stated: as inertia of the rotor only one of them could be.
TEST(Rivals, AWheelOfAnotherInertiaIsNoTorqueConstantForSure) {
  for (const double true_over_stated : {0.93, 1.085}) {
    const Answer answer = answer_to(wheel_log(0.21 * true_over_stated), rig_of(wheel(0.21)));
    expect_not_sure(answer);
    EXPECT_TRUE(stands_in_a_group(answer.report, "torque_constant_error", "load_inertia_error"));
    EXPECT_NE(answer.text.find("uncertain"), std::string::npos);
  }
}

// Whoever says which value is open gets that value.
TEST(Rivals, AWheelWhoseInertiaIsCalledUncertainIsCorrected) {
  const Answer answer =
      answer_to(wheel_log(0.21 * 1.085), rig_of(wheel(0.21), {"/load/inertia_kg_m2"}));
  EXPECT_EQ(answer.exit_code, 0) << answer.text;
  EXPECT_TRUE(answer.report["effects_added"].empty());
  ASSERT_EQ(answer.report["corrected"].size(), 1u);
  const json& inertia = answer.report["corrected"][0];
  EXPECT_NEAR(inertia["value"].get<double>(), 0.21 * 1.085,
              4.0 * inertia["standard_error"].get<double>());
}

// A wheel with viscous drag and an inertia that is misstated: N Kt g i = g J a + g b w, so that
// drag's size is no surer than g.
TEST(Rivals, FrictionBesideAMisstatedWheelIsOfNoSureSize) {
  const auto current_A = [](int run, double t) {
    return (0.21 * 1.07 * wave(run, t, 2) + 0.3 * wave(run, t, 1)) / kNewtonMetresPerAmpere;
  };
  const Answer answer = answer_to(log_of(current_A, no_sensor, 0.02), rig_of(wheel(0.21)));
  EXPECT_EQ(answer.report["verdict"], "explained") << answer.text;
  EXPECT_FALSE(answer.has_refined);
}

// A heavier pendulum asks for all torque in proportion, as a weaker motor does.
TEST(Rivals, APendulumOfAnotherMassIsNoTorqueConstantForSure) {
  constexpr double kLength_m = 0.32, kStated_kg = 1.6, kTrue_kg = 1.71;
  const auto current_A = [](int run, double t) {
    const double torque_Nm =
        kTrue_kg * kLength_m * (kLength_m * wave(run, t, 2) + 9.81 * std::sin(wave(run, t, 0)));
    return torque_Nm / kNewtonMetresPerAmpere;
  };
  const Answer answer =
      answer_to(log_of(current_A, no_sensor, 0.02), rig_of({{"type", "pendulum"},
                                                            {"mass_kg", kStated_kg},
                                                            {"length_m", kLength_m},
                                                            {"inertia_kg_m2", 0}}));
  expect_not_sure(answer);
  EXPECT_TRUE(stands_in_a_group(answer.report, "torque_constant_error", "load_mass_error"));
}

double drive_current_A(int run, double t) {
  return 5.0 * std::sin(1.3 * t + run) + 2.5 * std::sin(3.7 * t + 2.0 * run);
}

// Coulomb friction and an offset of the sensor: two directions that differ, of sensor or actuator.
TEST(Rivals, AnOffsetOfTheTorqueSensorIsNoAsymmetricFrictionForSure) {
  const auto torque_Nm = [](int run, double t) {
    return kNewtonMetresPerAmpere * drive_current_A(run, t) - std::copysign(0.22, wave(run, t, 1)) +
           0.13;
  };
  const Answer answer =
      answer_to(log_of(drive_current_A, torque_Nm, 0.005), rig_of({{"type", "dynamometer"}}));
  EXPECT_EQ(answer.report["verdict"], "explained") << answer.text;
  EXPECT_TRUE(stands_in_a_group(answer.report, "asymmetric_friction", "torque_offset"));
  for (const json& each : answer.report["effects_added"]) {
    const bool is_symmetric = each["effect"] == "coulomb_friction";
    EXPECT_EQ(each["certain"].get<bool>(), is_symmetric) << each;
  }
}

// Closed form of a first-order low pass: sin(w t + p) becomes sin(w t + p - atan w T)/hypot(1, w
// T).
TEST(Rivals, ALowPassOfTheTorqueSensorIsNoTorqueLagForSure) {
  constexpr double kLag_s = 0.03;
  const auto lagged = [](double amplitude, double frequency_rad_s, double phase, double t) {
    const double turn = frequency_rad_s * kLag_s;
    return amplitude / std::hypot(1.0, turn) *
           std::sin(frequency_rad_s * t + phase - std::atan(turn));
  };
  const auto current_A = [](int run, double t) {
    return drive_current_A(run, t) + 2.0 * std::sin(21.0 * t + run);
  };
  const auto torque_Nm = [&](int run, double t) {
    return kNewtonMetresPerAmpere *
           (lagged(5.0, 1.3, run, t) + lagged(2.5, 3.7, 2.0 * run, t) + lagged(2.0, 21.0, run, t));
  };
  const Answer answer =
      answer_to(log_of(current_A, torque_Nm, 0.005), rig_of({{"type", "dynamometer"}}));
  EXPECT_EQ(answer.report["verdict"], "explained") << answer.text;
  EXPECT_FALSE(answer.has_refined);
  EXPECT_TRUE(stands_in_a_group(answer.report, "torque_lag", "channel_lag"));
}

}  // namespace
}  // namespace torquewright::cli_test::rivals
