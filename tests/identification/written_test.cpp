// SPDX-License-Identifier: Apache-2.0
// What a refined document holds of a group that a log does not tell apart. Oracle: the closed form
// of a log in which the load's torque has one size, so that Coulomb friction and friction in
// proportion to the load are one column, and the white noise that was put on its sensor.
#include "identification/findings/written.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "identification/answer/refined_json.hpp"
#include "identification/answer/self_check.hpp"
#include "io/faults/json_text.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::identification::written_test {
namespace {

constexpr double kCoulomb_Nm = 0.5, kLoad_Nm = 5.0, kNoise_Nm = 0.02;

/// The motor pushes with 5 Nm more than the friction, always the same way.
std::string log_of_one_load() {
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0.0, kNoise_Nm);
  std::string text = "run,t,q,i,tau\n";
  for (int run = 0; run < 3; ++run) {
    for (int k = 0; k < 4000; ++k) {
      const double t = 0.005 * k;
      text += fmt::format("{},{:.3f},{:.6f},{:.6f},{:.6f}\n", run, t,
                          2.0 * t + std::sin((0.9 + 0.1 * run) * t), kLoad_Nm + kCoulomb_Nm,
                          kLoad_Nm + noise(random));
    }
  }
  return text;
}

constexpr const char* kActuator = R"({"kind": "actuator", "version": 1, "name": "drive",
  "motor": {"torque_constant_Nm_A": 0.1, "torque_constant_convention": "dc", "resistance_ohm": 0.5,
            "resistance_convention": "line_to_line"},
  "drive": {"bus_voltage_V": 48, "peak_current_A": 40},
  "gearbox": {"ratio": 10, "forward_efficiency": 1, "backward_efficiency": 1},
  "assumed": ["/motor/torque_constant_convention", "/motor/resistance_ohm",
              "/gearbox/forward_efficiency", "/gearbox/backward_efficiency"]})";
constexpr const char* kRig = R"({"kind": "rig", "version": 1, "name": "bench",
  "columns": {"run": "run", "t": "time_s", "q": "output_position_rad", "i": "motor_current_A",
              "tau": "output_torque_Nm"},
  "load": {"type": "dynamometer"}})";

TEST(Written, OfAGroupItsBestMemberWithWhatItLeaves) {
  const test::ScratchFolder folder;
  const std::vector<std::filesystem::path> logs = {folder.write("log.csv", log_of_one_load())};
  const Rig rig = read_rig(io::read_document(folder.write("rig.json", kRig), "rig"));
  const JointActuator nominal{"", actuator::read_actuator(folder.write("drive.json", kActuator))};
  IdentifyOptions options;
  options.analysis.only = {"coulomb_friction", "load_dependent_friction"};
  const Identification found = identify(logs, rig, {nominal}, options);
  ASSERT_EQ(found.verdict, Verdict::kCannotTell);
  const auto document = refined_actuator(found, nominal);
  ASSERT_EQ(document["effects"].size(), 1U);
  const std::string name = document["effects"][0]["effect"];
  const bool is_coulomb = name == "coulomb_friction";
  EXPECT_EQ(document["effects"][0]["provenance"]["undecided"],
            nlohmann::json({is_coulomb ? "load_dependent_friction" : "coulomb_friction"}));
  const auto file = folder.write("refined.json", io::json_text(document));
  const Identification judged = as_written(logs, rig, {{"", actuator::read_actuator(file)}}, found);
  EXPECT_EQ(broken_promise(found, judged), "");
  // White noise of 200 Hz below 8 Hz, less than the whole of it by far; and half a newton metre
  // where the document held nothing.
  EXPECT_LT(judged.equations.front().before.holdout_rms, kNoise_Nm);
  EXPECT_GT(found.equations.front().before.holdout_rms, 0.9 * kCoulomb_Nm);
}

EquationResult with_group(std::vector<std::string> effects, bool exact) {
  EquationResult result;
  result.verdict = Verdict::kCannotTell;
  result.added.emplace_back().effect = effects.front();
  result.confounded.push_back({std::move(effects), exact, "", exact ? "another region" : ""});
  return result;
}

TEST(Written, NothingOfAGroupThatMayBeTheLogsOrThatNoLogTells) {
  EXPECT_EQ(written_of(with_group({"viscous_friction", "quadratic_drag"}, false)).size(), 1U);
  EXPECT_TRUE(written_of(with_group({"torque_lag", "channel_delay"}, false)).empty());
  EXPECT_TRUE(written_of(with_group({"torque_constant_error", "reflected_inertia"}, true)).empty());
  EquationResult doubted = with_group({"viscous_friction", "quadratic_drag"}, false);
  doubted.added.front().doubt = "something speaks against it";
  EXPECT_TRUE(written_of(doubted).empty());
}

}  // namespace
}  // namespace torquewright::identification::written_test
