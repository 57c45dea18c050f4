// SPDX-License-Identifier: Apache-2.0
// Numbers that somebody will bring, to every option that takes one. What is not finite, or no
// number, is refused; the others are taken or refused, and lead to no nan or inf.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/nasty.hpp"

namespace torquewright::cli_test {
namespace {

using Words = std::vector<std::string>;

const std::string kDriven = "specs/actuator/d151_knee.json";
const std::string kJumper = "specs/robot/hopper.json";
const std::string kLow = "specs/trajectory/hopper_squat.csv";
const std::string kBenchRig = "specs/log/bench_rig.json";
const std::string kBenchActuator = "specs/log/bench_actuator.json";

/// An option, or a part of its value: the number stands between `before` and `after`.
struct NumberOption {
  std::string option;
  std::string sound;  ///< A number that it takes.
  std::string before = {}, after = {};
};

struct NumberCommand {
  Words command;
  std::vector<NumberOption> options;
};

std::vector<NumberCommand> actuator_commands() {
  const std::vector<NumberOption> supply{
      {"--bus-voltage", "60"}, {"--state-of-charge", "0.5"}, {"--winding-temperature", "300"}};
  const auto with_supply = [&](std::vector<NumberOption> options) {
    options.insert(options.end(), supply.begin(), supply.end());
    return options;
  };
  return {
      {{"actuator", "mor", kDriven, "--plot", "region.svg"},
       {{"--plot-voltage", "60"}, {"--plot-temperature", "300"}}},
      {{"actuator", "mor", kDriven},
       with_supply({{"--at-speed", "1"},
                    {"--accuracy", "1e-3"},
                    {"--need", "100", "", "@1"},
                    {"--need", "1", "100@", ""},
                    {"--ratio", "8", "", ":9"},
                    {"--ratio", "9", "8:"}})},
      {{"actuator", "check", "specs/trajectory/bench_lift.csv", "--joint",
        "knee=" + kBenchActuator},
       {{"--pause", "1"},
        {"--repeat", "2"},
        {"--from", "0"},
        {"--until", "0.5"},
        {"--bus-voltage", "20"},
        {"--winding-temperature", "300"}}},
      {{"actuator", "check", "specs/trajectory/knee_extension.csv", "--joint", "knee=" + kDriven},
       with_supply({})}};
}

std::vector<NumberCommand> hopper_commands() {
  return {{{"hopper", "check", kJumper, kLow},
           {{"--load-window", "0.01"},
            {"--ground-height", "0"},
            {"--contact-height", "0.001"},
            {"--contact-speed", "0.1"},
            {"--contact-time-constant", "0.01"},
            {"--residual-limit", "1"},
            {"--pause", "1"},
            {"--repeat", "2"},
            {"--from", "0"},
            {"--until", "0.5"},
            {"--bus-voltage", "60"},
            {"--state-of-charge", "0.5"},
            {"--winding-temperature", "300"}}},
          {{"hopper", "check", kJumper, kLow, "--candidates", "specs/actuator"},
           {{"--ratios", "8", "", ":9"}, {"--ratios", "9", "8:"}, {"--ratios", "1", "8:9:"}}},
          {{"hopper", "replay", kJumper, kLow, "--until", "0.05", "--stand", "0"},
           {{"--step", "0.0005"},
            {"--control-period", "0.001"},
            {"--latency", "0.001"},
            {"--ground-rise", "0.0005"}}},
          {{"hopper", "replay", kJumper, kLow, "--until", "0.05", "--stand", "0", "--impact",
            "invariant"},
           {{"--impact-blend", "0.01"}, {"--impact-window", "0.01"}}},
          {{"hopper", "replay", kJumper, kLow, "--until", "0.05", "--step", "0.0005"},
           {{"--stand", "0.01"}}},
          {{"hopper", "calibrate", kJumper, "--target", "cam=6", "--free",
            "/bodies/0/inertia_kg_m2/yy"},
           {{"--target", "7", "cav=", ":10"},
            {"--target", "7", "cav=7:"},
            {"--target", "7", "cav@tuck="}}},
          {{"hopper", "calibrate", kJumper, "--target", "cam=6", "--target", "cav@tuck=10"},
           {{"--free", "0.05", "/bodies/0/inertia_kg_m2/yy=", ":0.45"},
            {"--free", "0.45", "/bodies/0/inertia_kg_m2/yy=0.05:"}}},
          {{"hopper", "calibrate", kJumper, "--target", "cav@tuck=10", "--free",
            "/bodies/0/inertia_kg_m2/yy"},
           {{"--target", "6", "cam="}}},
          {{"hopper", "calibrate", kJumper, "--target", "cam=6", "--target", "cav@tuck=10",
            "--free", "/bodies/0/inertia_kg_m2/yy"},
           {{"--tolerance", "0.02"}, {"--posture", "2.2", "tuck=knee:"}}}};
}

std::vector<NumberCommand> identify_commands() {
  return {{{"identify", "specs/log/bench_as_built.csv", "--rig", kBenchRig, "--actuator",
            kBenchActuator},
           {{"--tolerance", "0.01"}}},
          {{"identify", "plan", kBenchActuator, "--rig", kBenchRig, "--separate",
            "coulomb_friction,viscous_friction", "--duration", "8"},
           {{"--noise", "0.1", "output_torque_Nm="},
            {"--position-range", "1"},
            {"--speed-limit", "3"}}},
          {{"identify", "plan", kBenchActuator, "--rig", kBenchRig, "--separate",
            "coulomb_friction,viscous_friction"},
           {{"--duration", "8"}}},
          {{"identify", "simulate", kDriven, "--rig", "specs/rig/knee_sweep.json", "--excitation",
            "specs/excitation/knee_sweep.csv"},
           {{"--noise", "0.1", "output_torque_Nm="}}}};
}

std::vector<NumberCommand> gearbox_commands() {
  const std::string problem = "specs/gearbox/d110a_ankle.json";
  const Words evaluate{"gearbox", "evaluate", problem};
  return {{{"gearbox", "optimize", problem},
           {{"--time-limit", "10"}, {"--top", "2"}, {"--max-nodes", "1000"}}},
          {{"gearbox", "evaluate", problem, "--teeth", "18,54"}, {{"--planet-count", "3"}}},
          {{"gearbox", "evaluate", problem, "--planet-count", "3"},
           {{"--teeth", "18", "", ",54"}, {"--teeth", "54", "18,"}}},
          {{"gearbox", "evaluate", problem, "--teeth", "18,54", "--planet-count", "3"},
           {{"--module", "0.6"},
            {"--profile-shift", "0.1", "", ",0,0"},
            {"--profile-shift", "0", "0,0,"}}},
          {{"gearbox", "strength", "specs/gearbox/d110a_strength.json"},
           {{"--torque", "21"}, {"--torque", "21", "17,"}}},
          {{"gearbox", "strength", "specs/gearbox/d110a_strength.json", "--torque", "21"},
           {{"--face-widths", "8"},
            {"--modules", "0.6"},
            {"--cycles", "1e6"},
            {"--load-sharing", "1.2"}}},
          {{"gearbox", "strength", "specs/gearbox/d151_knee_result.json", "--torque", "21",
            "--steel", "case_hardened"},
           {{"--face-width", "8", "10,"}, {"--face-width", "10", "", ",8"}}},
          {{"gearbox", "strength", "specs/gearbox/d151_knee_result.json", "--torque", "21",
            "--steel", "case_hardened", "--face-width", "10,8"},
           {{"--rim", "1.2", "sun="}, {"--design", "1"}}}};
}

/// An actuator with a battery that empties.
void give_battery(const Workplace& place, const std::string& actuator) {
  auto document = nlohmann::json::parse(place.text(actuator));
  document["battery"] = {{"series_cells", 16},
                         {"parallel_cells", 4},
                         {"cell_open_circuit_V",
                          {{{"state_of_charge", 0}, {"voltage_V", 3.2}},
                           {{"state_of_charge", 1}, {"voltage_V", 4.2}}}},
                         {"cell_resistance_ohm", 0.015}};
  place.write(actuator, document.dump());
}

constexpr std::size_t kFilesThere = 2;  // specs, region.svg

void expect_numbers_judged(const std::vector<NumberCommand>& commands) {
  const Workplace place;
  fs::copy(in_repository("specs"), place.path("specs"), fs::copy_options::recursive);
  for (const char* actuator : {"d151_knee", "d110a_ankle"}) {
    give_battery(place, std::string("specs/actuator/") + actuator + ".json");
  }
  place.write("region.svg", "");
  for (const NumberCommand& each : commands) {
    for (const NumberOption& option : each.options) {
      const auto with_number = [&](const std::string& number) {
        Words command = each.command;
        command.insert(command.end(), {option.option, option.before + number + option.after});
        return command;
      };
      expect_sound(place, with_number(option.sound), kFilesThere);
      for (const NastyNumber& number : nasty_numbers()) {
        const std::string what = option.option + " " + option.before + number.text + option.after;
        expect_judged(place, with_number(number.text), what, kFilesThere, number.is_refused);
      }
    }
  }
}

TEST(NastyNumbers, OfActuators) { expect_numbers_judged(actuator_commands()); }
TEST(NastyNumbers, OfRobots) { expect_numbers_judged(hopper_commands()); }
TEST(NastyNumbers, OfLogs) { expect_numbers_judged(identify_commands()); }
TEST(NastyNumbers, OfGearboxes) { expect_numbers_judged(gearbox_commands()); }

}  // namespace
}  // namespace torquewright::cli_test
