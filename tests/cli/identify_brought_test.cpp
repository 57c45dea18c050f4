// SPDX-License-Identifier: Apache-2.0
// What users bring to `identify`: loads that change from run to run, logs of other programs, and
// what they take away for these.
#include <fmt/format.h>
#include <gtest/gtest.h>

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
