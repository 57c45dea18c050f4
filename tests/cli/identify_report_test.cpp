// SPDX-License-Identifier: Apache-2.0
// What `identify` says beside its verdict: runs, models within the noise, lines, what was not
// asked.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "io/documents/schema.hpp"
#include "tests/cli/example_bench.hpp"
#include "tests/cli/spoilt_log.hpp"

namespace torquewright::cli_test::identify_report {
namespace {

using nlohmann::json;

/// What `identify` reports of a bench.
struct Bench : cli_test::Bench {
  using cli_test::Bench::Bench;

  Outcome run(const std::vector<std::string>& more) const {
    return cli_test::Bench::run({"identify"}, more);
  }
  json report(std::vector<std::string> more = {}) const {
    more.emplace_back("--json");
    const Outcome outcome = run(more);
    EXPECT_EQ(outcome.err, "");
    json report = json::parse(outcome.out);
    EXPECT_TRUE(io::conforms(report, "identification_report")) << outcome.out;
    return report;
  }
};

TEST(IdentifyReport, RefusesAnEffectThatIsAskedAndNotAsked) {
  const Outcome outcome =
      Bench().run({"--only", "gear_ripple,coulomb_friction", "--without", "coulomb_friction"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("--only and --without: \"coulomb_friction\" is in both"),
            std::string::npos)
      << outcome.err;
}

TEST(IdentifyReport, SaysWhatWasNotAsked) {
  const Bench bench;
  EXPECT_FALSE(bench.report().contains("not_asked"));
  const std::vector<std::string> without = {"--without", "load_dependent_friction,gear_ripple"};
  json not_asked = bench.report(without)["not_asked"];
  std::sort(not_asked.begin(), not_asked.end());
  EXPECT_EQ(not_asked, json({"gear_ripple", "load_dependent_friction"}));
  const Outcome text = bench.run({"--without", "gear_ripple", "--report", "report.html"});
  if (text.err.find("gnuplot") != std::string::npos) GTEST_SKIP() << "gnuplot is not installed";
  EXPECT_NE(text.out.find("\nNot asked: gear_ripple.\n"), std::string::npos) << text.out;
  EXPECT_NE(bench.place.text("report.html").find("Not asked: gear_ripple."), std::string::npos);
}

// Oracle: the errors of all fitted runs and of the one that is held out, which the report states
// too; the runs are of one length.
TEST(IdentifyReport, StatesTheErrorOfEachRun) {
  const json equation = Bench().report()["equations"][0];
  ASSERT_EQ(equation["runs"].size(), 4u);
  for (const auto& [all, own] :
       {std::pair{"before", "rms_before"}, std::pair{"after", "rms_after"}}) {
    double fitted = 0.0;
    for (const json& run : equation["runs"]) {
      EXPECT_EQ(run["held_out"], run["run"] == "run_4");
      const double rms = run[own];
      if (run["held_out"] == true) {
        EXPECT_DOUBLE_EQ(rms, equation[all]["holdout_rms"]);
      } else {
        fitted += rms * rms / 3.0;
      }
    }
    // Rows that rest are not counted: the runs are of nearly one length.
    EXPECT_NEAR(std::sqrt(fitted), equation[all]["train_rms"], 0.05 * std::sqrt(fitted));
  }
}

TEST(IdentifyReport, DrawsAndListsEachRun) {
  const Bench bench;
  const Outcome outcome = bench.run({"--report", "report.html"});
  if (outcome.err.find("gnuplot") != std::string::npos) GTEST_SKIP() << "gnuplot is not installed";
  const std::string page = bench.place.text("report.html");
  EXPECT_NE(page.find("Measured and predicted, run by run"), std::string::npos);
  EXPECT_NE(page.find("<td>run_4</td><td><b>held out</b></td>"), std::string::npos);
  EXPECT_NE(page.find("run_4, held out: "), std::string::npos);  // the picture's own title
}

// A log that cannot tell by construction: what was put in is among the models, and what would
// decide is said of all but the one that was taken.
TEST(IdentifyReport, ListsTheModelsWithinTheNoise) {
  const oracles::Scenario scenario = oracles::draw(oracles::LogClass::kCannotTell, 3);
  const json report = Bench(scenario).report();
  ASSERT_EQ(report["verdict"], "cannot_tell");
  const json& models = report["equations"][0]["models"];
  ASSERT_GE(models.size(), 2u);
  EXPECT_FALSE(models[0].contains("decided_by"));
  for (std::size_t i = 1; i < models.size(); ++i) EXPECT_NE(models[i]["decided_by"], "") << i;
  const auto holds = [&](const json& model) {
    return std::any_of(model["effects"].begin(), model["effects"].end(), [&](const json& effect) {
      return effect["effect"] == scenario.truth.effects[0].effect;
    });
  };
  EXPECT_TRUE(std::any_of(models.begin(), models.end(), holds)) << models;
}

// Oracle: the hum that was put in, 0.3 Nm at 70 Hz of a log of 200 Hz.
TEST(IdentifyReport, TellsOfAHumAboveItsBand) {
  const Bench bench;
  SpoiltLog log(bench.place.text("log.csv"));
  for (std::size_t row = 0; row < log.rows.size(); ++row) {
    const double t = log.number(row, "t_s");
    log.at(row, "tau_Nm") = fmt::format(
        "{:.6g}", log.number(row, "tau_Nm") + 0.3 * std::sin(2.0 * std::numbers::pi * 70.0 * t));
  }
  EXPECT_TRUE(bench.report()["equations"][0]["lines"].empty());
  bench.place.write("log.csv", log.text());
  const json report = bench.report();
  const json& lines = report["equations"][0]["lines"];
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(lines[0]["frequency_hz"], 70.0, 0.02);
  EXPECT_NEAR(lines[0]["amplitude"], 0.3, 4.0 * lines[0]["standard_error"].get<double>());
  EXPECT_EQ(lines[0]["keeps_to"], "time");
  const json& findings = report["data_findings"];
  EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [&](const json& each) {
    return each["severity"] == "warning" && each["sentence"] == lines[0]["sentence"];
  })) << findings;
  EXPECT_EQ(report["verdict"], "explained");
}

}  // namespace
}  // namespace torquewright::cli_test::identify_report
