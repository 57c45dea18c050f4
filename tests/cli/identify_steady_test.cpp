// SPDX-License-Identifier: Apache-2.0
// A dynamometer's averaged points of speed, current and torque, made by closed forms with white
// noise on the torque, and the rows in the order of somebody who goes through speeds one after the
// other. Oracle: what was put in.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test::steady {
namespace {

using nlohmann::json;

constexpr double kTorquePerAmpere_Nm_A = 9.0 * 0.09;
constexpr double kNoise_Nm = 0.02;

const json kActuator = {
    {"kind", "actuator"},
    {"version", 1},
    {"name", "nine to one"},
    {"motor",
     {{"torque_constant_Nm_A", 0.09},
      {"torque_constant_convention", "dc"},
      {"resistance_ohm", 0.1},
      {"resistance_convention", "dc"},
      {"rotor_inertia_kg_m2", 1e-5},
      {"pole_pairs", 7}}},
    {"drive", {{"bus_voltage_V", 48}, {"peak_current_A", 30}}},
    {"gearbox", {{"ratio", 9}, {"forward_efficiency", 1}, {"backward_efficiency", 1}}}};

json rig(const json& load = {{"type", "dynamometer"}, {"steady", true}}) {
  return {{"kind", "rig"},
          {"version", 1},
          {"name", "map"},
          {"columns",
           {{"n", "time_s"},
            {"speed_rpm", {{"quantity", "output_velocity_rad_s"}, {"unit", "rpm"}}},
            {"i_A", "motor_current_A"},
            {"torque_Nm", "output_torque_Nm"}}},
          {"load", load}};
}

/// Torque at the output of a current at a speed.
using Law = std::function<double(double current_A, double speed_rad_s)>;

std::string points(const Law& law, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> unit(0.0, 1.0);
  std::ostringstream csv;
  csv.precision(9);
  csv << "n,speed_rpm,i_A,torque_Nm\n";
  int count = 0;
  for (const double set : {-30, -24, -18, -12, -6, -3, -1, 1, 3, 6, 12, 18, 24, 30}) {
    for (int step = -10; step <= 10; ++step) {
      const double speed = set * (1.0 + 0.02 * unit(random)), current = 2.0 * step + 0.01;
      csv << count++ << ',' << speed * 30.0 / M_PI << ',' << current << ','
          << law(current, speed) + kNoise_Nm * unit(random) << '\n';
    }
  }
  return csv.str();
}

json found(const Law& law, unsigned seed, std::vector<std::string> more = {}) {
  const Workplace place;
  place.write("map.csv", points(law, seed));
  place.write("rig.json", rig().dump());
  place.write("actuator.json", kActuator.dump());
  std::vector<std::string> line = {"identify",   "map.csv",       "--rig", "rig.json",
                                   "--actuator", "actuator.json", "--json"};
  line.insert(line.end(), more.begin(), more.end());
  const Outcome said = place.run(line);
  EXPECT_TRUE(said.exit_code == 0 || said.exit_code == 1) << said.err;
  return json::parse(said.out);
}

double drag(double speed_rad_s) { return std::copysign(0.3, speed_rad_s) + 0.02 * speed_rad_s; }

/// The named effects, and that each is certain with the parameters within three errors of these.
void expect_exactly(const json& report, const std::map<std::string, json>& truth) {
  EXPECT_EQ(report["verdict"], "explained");
  ASSERT_EQ(report["effects_added"].size(), truth.size()) << report["effects_added"].dump(1);
  for (const json& added : report["effects_added"]) {
    const std::string name = added["effect"];
    ASSERT_TRUE(truth.contains(name)) << name;
    EXPECT_EQ(added["certain"], true) << name;
    for (const auto& [parameter, value] : truth.at(name).items()) {
      EXPECT_NEAR(added["parameters"][parameter].get<double>(), value.get<double>(),
                  3.0 * added["standard_error"][parameter].get<double>())
          << name << ' ' << parameter;
    }
  }
}

TEST(SteadyStates, NameTheFrictionThatIsMissing) {
  const json report =
      found([](double i, double w) { return kTorquePerAmpere_Nm_A * i - drag(w); }, 1);
  expect_exactly(report, {{"coulomb_friction", {{"coulomb_Nm", 0.3}}},
                          {"viscous_friction", {{"viscous_Nm_s_rad", 0.02}}}});
  // The floor is the noise that was put in: 294 points tell a deviation to 5 %, so 3 of these.
  EXPECT_NEAR(report["noise_floor"]["rms"].get<double>(), kNoise_Nm, 0.15 * kNoise_Nm);
}

TEST(SteadyStates, TellATorqueConstantFromFriction) {
  expect_exactly(
      found([](double i, double w) { return 0.93 * kTorquePerAmpere_Nm_A * i - drag(w); }, 2),
      {{"torque_constant_error", {{"factor", 0.93}}},
       {"coulomb_friction", {{"coulomb_Nm", 0.3}}},
       {"viscous_friction", {{"viscous_Nm_s_rad", 0.02}}}});
}

TEST(SteadyStates, TellFrictionOfTheLoadBothWays) {
  const auto law = [](double i, double w) {
    const double before = kTorquePerAmpere_Nm_A * i - drag(w);
    return before / (1.0 + 0.08 * (before * w > 0.0 ? 1.0 : -1.0));
  };
  expect_exactly(found(law, 3),
                 {{"load_dependent_friction",
                   {{"driving_coefficient", 0.08}, {"backdriving_coefficient", 0.08}}},
                  {"coulomb_friction", {{"coulomb_Nm", 0.3}}},
                  {"viscous_friction", {{"viscous_Nm_s_rad", 0.02}}}});
}

// Two of fourteen speeds tell the transition; the search once ended beside the optimum there, with
// a law of value 0 that "removed 4 %".
TEST(SteadyStates, TellStribeckFrictionByTwoSlowSpeeds) {
  const auto law = [](double i, double w) {
    return kTorquePerAmpere_Nm_A * i - drag(w) -
           std::copysign(0.4 * std::exp(-(w / 2.0) * (w / 2.0)), w);
  };
  expect_exactly(found(law, 3),
                 {{"stribeck_friction",
                   {{"coulomb_Nm", 0.3}, {"breakaway_Nm", 0.7}, {"stribeck_velocity_rad_s", 2.0}}},
                  {"viscous_friction", {{"viscous_Nm_s_rad", 0.02}}}});
}

TEST(SteadyStates, OfWhatIsStatedHaveNothingMissing) {
  for (const unsigned seed : {4u, 5u, 6u}) {
    const json report = found([](double i, double) { return kTorquePerAmpere_Nm_A * i; }, seed);
    EXPECT_EQ(report["verdict"], "nothing_missing") << seed;
    EXPECT_TRUE(report["effects_added"].empty()) << seed;
  }
}

// A counter is no time, and no state has one before it: the order of the rows changes nothing that
// is found.
TEST(SteadyStates, NeedAVelocityOrAPositionAndADynamometer) {
  const Workplace place;
  place.write("map.csv", points([](double i, double) { return i; }, 1));
  place.write("actuator.json", kActuator.dump());
  const auto said_of = [&](const json& changed) {
    place.write("rig.json", changed.dump());
    const Outcome said =
        place.run({"identify", "map.csv", "--rig", "rig.json", "--actuator", "actuator.json"});
    EXPECT_EQ(said.exit_code, 2);
    return said.err;
  };
  json blind = rig();
  blind["columns"].erase("speed_rpm");
  blind["ignore"] = {"speed_rpm"};
  EXPECT_NE(said_of(blind).find("no column is a velocity or a position; steady states are states"),
            std::string::npos);
  EXPECT_NE(said_of(rig({{"type", "free"}, {"inertia_kg_m2", 0.1}, {"steady", true}}))
                .find("/load/steady: has no meaning for a load of type \"free\""),
            std::string::npos);
  json timeless = rig({{"type", "dynamometer"}});
  timeless["columns"].erase("n");
  timeless["ignore"] = {"n"};
  EXPECT_NE(said_of(timeless).find("say \"steady\": true"), std::string::npos);
}

}  // namespace
}  // namespace torquewright::cli_test::steady
