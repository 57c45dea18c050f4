// SPDX-License-Identifier: Apache-2.0
// What users bring to `identify`: loads that change from run to run, logs of other programs, and
// what they take away for these.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

constexpr double kRate_Hz = 200.0;
constexpr int kRows = 2400;

/// A drive of round numbers: N Kt = 1 Nm/A, without rotor or friction.
json drive() {
  return json::parse(R"({"kind": "actuator", "version": 1, "name": "drive",
    "motor": {"torque_constant_Nm_A": 0.1, "torque_constant_convention": "dc", "resistance_ohm": 0.5,
      "resistance_convention": "dc", "rotor_inertia_kg_m2": 1e-12},
    "drive": {"bus_voltage_V": 48, "peak_current_A": 100},
    "gearbox": {"ratio": 10, "forward_efficiency": 1, "backward_efficiency": 1}})");
}

/// q = 0.8 sin(2 t + k) + 0.3 sin(5.3 t), and its acceleration.
double angle_rad(int k, double t) { return 0.8 * std::sin(2.0 * t + k) + 0.3 * std::sin(5.3 * t); }
double acceleration_rad_s2(int k, double t) {
  return -3.2 * std::sin(2.0 * t + k) - 8.427 * std::sin(5.3 * t);
}

/// A pendulum of 2 kg at 0.25 m whose mass is `masses_kg` by run, driven as the current says.
std::string pendulum_log(const std::vector<double>& masses_kg) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> noise;
  std::string text = "run,t_s,i_A,q_rad\n";
  for (int k = 0; k < static_cast<int>(masses_kg.size()); ++k) {
    const double mass_kg = masses_kg[static_cast<std::size_t>(k)];
    for (int i = 0; i < kRows; ++i) {
      const double t = i / kRate_Hz, q = angle_rad(k, t);
      const double torque_Nm =
          mass_kg * (0.0625 * acceleration_rad_s2(k, t) + 9.81 * 0.25 * std::sin(q));
      text += fmt::format("r{},{:.6f},{:.7f},{:.7f}\n", k, t, torque_Nm + 0.01 * noise(random),
                          q + 1e-5 * noise(random));
    }
  }
  return text;
}

json pendulum(double mass_kg) {
  return {{"type", "pendulum"}, {"mass_kg", mass_kg}, {"length_m", 0.25}, {"inertia_kg_m2", 0}};
}

json pendulum_rig() {
  return {{"kind", "rig"},
          {"version", 1},
          {"columns",
           {{"run", "run"},
            {"t_s", "time_s"},
            {"i_A", "motor_current_A"},
            {"q_rad", "output_position_rad"}}},
          {"load", pendulum(2.0)}};
}

Outcome identified(const Workplace& place, const json& rig) {
  place.write("actuator.json", drive().dump());
  place.write("rig.json", rig.dump());
  return place.run(
      {"identify", "log.csv", "--rig", "rig.json", "--actuator", "actuator.json", "--json"});
}

/// The log with some of these columns, and the refusal or the findings.
json rig_with(const std::vector<std::string>& columns, const json& load) {
  json rig = pendulum_rig();
  for (const char* column : {"i_A", "q_rad"}) {
    if (std::find(columns.begin(), columns.end(), column) != columns.end()) continue;
    rig["columns"].erase(column);
    rig["ignore"].push_back(column);
  }
  rig["load"] = load;
  return rig;
}

TEST(Channels, ThatAllowNoEquationAreRefusedByName) {
  const Workplace place;
  place.write("log.csv", pendulum_log({2.0, 2.0}));
  const Outcome without_drive = identified(place, rig_with({"q_rad"}, {{"type", "dynamometer"}}));
  EXPECT_EQ(without_drive.exit_code, 2);
  EXPECT_NE(without_drive.err.find(
                "rig.json#/columns: no torque balance: nothing says what the motor does; add "
                "motor_current_A, reported_torque_Nm, commanded_torque_Nm, winding_voltage_V or "
                "duty; and neither output_torque_Nm nor linear_force_N nor a load with inertia"),
            std::string::npos)
      << without_drive.err;
  EXPECT_NE(without_drive.err.find("no winding voltage: add motor_current_A and winding_voltage_V "
                                   "or duty\n"),
            std::string::npos);
  EXPECT_NE(without_drive.err.find("no twist: add motor_position_rad\n"), std::string::npos);
  const Outcome without_motion = identified(place, rig_with({"i_A"}, pendulum(2.0)));
  EXPECT_EQ(without_motion.exit_code, 2);
  EXPECT_NE(without_motion.err.find("no column is a position or velocity"), std::string::npos);
}

// Some equation is allowed, the torque balance is not.
TEST(Channels, ThatAllowNoTorqueBalanceAreSaid) {
  const Workplace place;
  place.write("log.csv", pendulum_log({2.0, 2.0, 2.0}));
  json rig = rig_with({"q_rad"}, pendulum(2.0));
  rig["ignore"] = json::array();
  rig["columns"]["i_A"] = "output_velocity_rad_s";  // whatever it is
  const Outcome outcome = identified(place, rig);
  EXPECT_NE(outcome.out.find("no torque balance: nothing says what the motor does"),
            std::string::npos)
      << outcome.out << outcome.err;
}

// Oracle: closed form. 4 kg on a spindle, N Kt = 1 N/A, viscous friction of 3 N s/m on the motor's
// side of a force sensor.
TEST(LinearAxis, IsIdentifiedInMetresAndNewtons) {
  std::mt19937_64 random(12);
  std::normal_distribution<double> noise;
  std::string text = "run,t_s,i_A,x_m,F_N\n";
  for (int k = 0; k < 4; ++k) {
    for (int i = 0; i < kRows; ++i) {
      const double t = i / kRate_Hz;
      const double speed_m_s = 1.6 * std::cos(2.0 * t + k) + 1.59 * std::cos(5.3 * t);
      const double force_N = 4.0 * acceleration_rad_s2(k, t);
      text += fmt::format("r{},{:.6f},{:.7f},{:.7f},{:.5f}\n", k, t,
                          force_N + 3.0 * speed_m_s + 1e-4 * noise(random),
                          angle_rad(k, t) + 1e-6 * noise(random), force_N + 0.2 * noise(random));
    }
  }
  const Workplace place;
  place.write("log.csv", text);
  json rig = pendulum_rig();
  rig["columns"].erase("q_rad");
  rig["columns"]["x_m"] = "linear_position_m";
  rig["columns"]["F_N"] = "linear_force_N";
  for (const char* load :
       {R"({"type": "linear_axis", "mass_kg": 4})", R"({"type": "dynamometer"})"}) {
    rig["load"] = json::parse(load);
    const Outcome outcome = identified(place, rig);
    const json report = json::parse(outcome.out);
    EXPECT_EQ(report["verdict"], "explained");
    EXPECT_EQ(report["quantity"], "linear_force_N");
    EXPECT_EQ(report["unit"], "N");
    ASSERT_EQ(report["effects_added"].size(), 1u);
    EXPECT_EQ(report["effects_added"][0]["effect"], "viscous_friction");
    EXPECT_NEAR(
        report["effects_added"][0]["parameters"]["viscous_Nm_s_rad"].get<double>(), 3.0,
        4.0 * report["effects_added"][0]["standard_error"]["viscous_Nm_s_rad"].get<double>());
    for (const json& equation : report["equations"]) {
      EXPECT_EQ(equation["quantity"].get<std::string>().substr(0, 7), "linear_");
    }
  }
}

// Oracle: V = R/(N Kt) (m l^2 a + m g l sin q) + Ke N w: 0.5 V/Nm, 1 V s/rad, 0.125 kg m^2.
TEST(OutputAs, StandsInPlaceOfTheReport) {
  const Workplace place;
  place.write("log.csv", pendulum_log({2.0, 2.0, 2.0}));
  place.write("actuator.json", drive().dump());
  place.write("rig.json", pendulum_rig().dump());
  const auto written_as = [&](const char* format) {
    return place.run({"identify", "log.csv", "--rig", "rig.json", "--actuator", "actuator.json",
                      "--as", format});
  };
  const Outcome frc = written_as("frc");
  EXPECT_EQ(frc.exit_code, 0) << frc.err;
  EXPECT_EQ(frc.out.substr(0, frc.out.find(" (times")),
            "kS        0 V\nkV        1 V s/rad\nkA   0.0625 V s^2/rad\nkG   2.4525 V");
  EXPECT_EQ(json::parse(written_as("bam").out)["model"], "m1");
  const Outcome unknown = written_as("fcr");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("\"fcr\" is not one of frc, bam"), std::string::npos) << unknown.err;
}

// Oracle: closed form. Weights are exchanged between runs.
TEST(LoadsByRun, ExplainWhatOneLoadCannot) {
  const Workplace place;
  place.write("log.csv", pendulum_log({2.0, 1.0, 2.0, 3.0}));
  json rig = pendulum_rig();
  EXPECT_NE(json::parse(identified(place, rig).out)["verdict"], "nothing_missing");
  rig["loads"] = {{"r1", pendulum(1.0)}, {"r3", pendulum(3.0)}};
  const Outcome outcome = identified(place, rig);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["verdict"], "nothing_missing") << outcome.out;
}

// The mass of one run alone is not known: 1.1 kg are stated of 1.
TEST(LoadsByRun, AreCorrectedWhereTheyAreUncertain) {
  const Workplace place;
  place.write("log.csv", pendulum_log({2.0, 1.0, 2.0, 3.0}));
  json rig = pendulum_rig();
  rig["loads"] = {{"r1", pendulum(1.1)}, {"r3", pendulum(3.0)}};
  rig["uncertain"] = {"/loads/r1/mass_kg"};
  const json report = json::parse(identified(place, rig).out);
  EXPECT_EQ(report["verdict"], "nothing_missing") << report.dump(1).substr(0, 2000);
  ASSERT_EQ(report["corrected"].size(), 1u);
  EXPECT_EQ(report["corrected"][0]["pointer"], "/loads/r1/mass_kg");
  const double error = report["corrected"][0]["standard_error"];
  EXPECT_NEAR(report["corrected"][0]["value"].get<double>(), 1.0, 4.0 * error);
}

}  // namespace
}  // namespace torquewright::cli_test
