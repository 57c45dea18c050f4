// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/bad_log_bench.hpp"

#include <gtest/gtest.h>

#include "io/documents/schema.hpp"
#include "tests/cli/four_quadrants.hpp"

namespace torquewright::cli_test::bad_logs {
namespace {

using nlohmann::json;

constexpr double kCoulomb_Nm = 0.6;
constexpr double kErrors = 4.0;  ///< Standard errors of a fit to one fixed log.

std::string simulated_text(double speed_scale) {
  const Workplace place;
  json truth = json::parse(text_of(in_repository("specs/log/bench_actuator.json")));
  truth["effects"] = {{{"effect", "coulomb_friction"},
                       {"parameters", {{"coulomb_Nm", kCoulomb_Nm}}},
                       {"provenance", "assumed"}}};
  place.write("truth.json", truth.dump());
  place.write("rig.json", rig_document().dump());
  place.write("excitation.csv", four_quadrants(kRowsPerRun, speed_scale));
  const Outcome outcome = place.run(
      {"identify", "simulate", "truth.json", "--rig", "rig.json", "--excitation", "excitation.csv",
       "--noise", "output_torque_Nm=0.2", "--noise", "output_position_rad=0.0005", "--noise",
       "output_velocity_rad_s=0.01", "--noise", "motor_current_A=0.05"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return outcome.out;
}

}  // namespace

json rig_document() {
  return {{"kind", "rig"},
          {"version", 1},
          {"name", "bench"},
          {"columns",
           {{"run", "run"},
            {"t_s", "time_s"},
            {"q_rad", "output_position_rad"},
            {"w_rad_s", "output_velocity_rad_s"},
            {"i_A", "motor_current_A"},
            {"tau_Nm", "output_torque_Nm"}}},
          {"load", {{"type", "dynamometer"}}},
          {"holdout_runs", {"run_4"}}};
}

SpoiltLog simulated(double speed_scale) { return SpoiltLog(simulated_text(speed_scale)); }

SpoiltLog good() {
  static const SpoiltLog log = simulated(1.0);
  return log;
}

Answer identify(const SpoiltLog& log, const json& rig) {
  const Workplace place;
  place.write("log.csv", log.text());
  place.write("rig.json", rig.dump());
  place.write("actuator.json", text_of(in_repository("specs/log/bench_actuator.json")));
  const auto before = place.files();
  Answer answer;
  answer.outcome = place.run({"identify", "log.csv", "--rig", "rig.json", "--actuator",
                              "actuator.json", "--json", "--refined", "refined.json"});
  for (const auto& [name, text] : place.files()) {
    if (!before.contains(name)) answer.written.push_back(name);
  }
  if (!answer.outcome.out.empty()) {
    answer.report = json::parse(answer.outcome.out);  // refuses NaN and infinity
    EXPECT_TRUE(io::conforms(answer.report, "identification_report")) << answer.outcome.out;
  }
  return answer;
}

void expect_refused(const SpoiltLog& log, const std::string& said, const json& rig) {
  const Answer answer = identify(log, rig);
  EXPECT_EQ(answer.outcome.exit_code, 2) << said;
  EXPECT_EQ(answer.outcome.out, "") << said;
  EXPECT_NE(answer.outcome.err.find(said), std::string::npos) << answer.outcome.err;
  EXPECT_EQ(answer.written, std::vector<std::string>{}) << said;
}

void expect_finding(const Answer& answer, const std::string& severity, const std::string& said) {
  for (const json& finding : answer.report["data_findings"]) {
    const std::string sentence = finding["sentence"];
    if (finding["severity"] == severity && sentence.find(said) != std::string::npos) return;
  }
  ADD_FAILURE() << "no " << severity << " \"" << said << "\" in "
                << answer.report["data_findings"].dump(1);
}

void expect_truth(const Answer& answer) {
  ASSERT_EQ(answer.outcome.exit_code, 0) << answer.outcome.err;
  EXPECT_EQ(answer.report["verdict"], "explained");
  ASSERT_EQ(answer.report["effects_added"].size(), 1u) << answer.report["effects_added"].dump(1);
  const json& effect = answer.report["effects_added"][0];
  EXPECT_EQ(effect["effect"], "coulomb_friction");
  EXPECT_NEAR(effect["parameters"]["coulomb_Nm"].get<double>(), kCoulomb_Nm,
              kErrors * effect["standard_error"]["coulomb_Nm"].get<double>());
  EXPECT_EQ(answer.written, std::vector<std::string>{"refined.json"});
}

void expect_cannot_tell(const Answer& answer, const std::string& said) {
  EXPECT_EQ(answer.outcome.exit_code, 3);
  EXPECT_EQ(answer.report["verdict"], "cannot_tell");
  EXPECT_TRUE(answer.report["effects_added"].empty());
  EXPECT_EQ(answer.written, std::vector<std::string>{});
  expect_finding(answer, "error", said);
}

}  // namespace torquewright::cli_test::bad_logs
