// SPDX-License-Identifier: Apache-2.0
// `identify` as a user runs it. Logs come from the truth of tests/oracles/bench_log, which shares
// no code with the tool; the example in specs/log was drawn there too, with a load-dependent
// friction of 0.14 driving and 0.10 back-driven that its actuator does not declare.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/documents/schema.hpp"
#include "tests/cli/example_bench.hpp"
#include "tests/cli/shell_words.hpp"
#include "tests/cli/well_formed.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;
using oracles::LogClass;

/// Fits are within so many standard errors of the truth (fixed seeds).
constexpr double kErrors = 4.0;

/// The report, which has the shape of its schema.
json report_of(const Outcome& outcome) {
  json report = json::parse(outcome.out);
  EXPECT_TRUE(io::conforms(report, "identification_report")) << outcome.out;
  return report;
}

TEST(Identify, NamesTheUndeclaredEffect) {
  const oracles::Scenario scenario = oracles::draw_effect("viscous_friction", 3);
  const Bench bench(scenario);
  const Outcome outcome = bench.run({"identify"}, {"--json"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  const json report = report_of(outcome);
  EXPECT_EQ(report["verdict"], "explained");
  ASSERT_EQ(report["effects_added"].size(), 1u);
  const json& effect = report["effects_added"][0];
  EXPECT_EQ(effect["effect"], "viscous_friction");
  EXPECT_EQ(effect["family"], "actuator");
  const char* key = "viscous_Nm_s_rad";
  EXPECT_NEAR(effect["parameters"][key].get<double>(), scenario.truth.effects[0].parameters.at(key),
              kErrors * effect["standard_error"][key].get<double>());
  EXPECT_LT(report["after"]["holdout_rms"], report["before"]["holdout_rms"]);
  EXPECT_EQ(report["inputs"].size(), bench.logs.size() + 2);
}

TEST(Identify, NamesNothingWhereNothingIsMissing) {
  const Bench bench(oracles::draw(LogClass::kNone, 3));
  const Outcome outcome = bench.run({"identify"}, {"--json", "--refined", "refined.json"});
  EXPECT_EQ(outcome.exit_code, 0);
  const json report = report_of(outcome);
  EXPECT_EQ(report["verdict"], "nothing_missing");
  EXPECT_TRUE(report["effects_added"].empty());
  const json nominal = json::parse(bench.place.text("actuator.json"));
  EXPECT_EQ(json::parse(bench.place.text("refined.json")), nominal);
}

TEST(Identify, SaysAllStepsInItsText) {
  const Outcome outcome = Bench().run({"identify"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(
      outcome.out.starts_with("log.csv on \"knee on the bench\": explained\n"
                              "Missing from the model: load_dependent_friction. With it "
                              "what is left is noise.\n"))
      << outcome.out;
  for (const char* step : {"\n1 log ", "\n2 residual ", "\n3 noise floor ", "\n4 evidence ",
                           "\n5 selection ", "\n6 refined ", "\nnext "}) {
    EXPECT_NE(outcome.out.find(step), std::string::npos) << step << " in\n" << outcome.out;
  }
}

// The effect that is missing may not be named: then nothing else takes its name.
TEST(Identify, AsksOnlyWhatItMay) {
  const Bench bench;
  const json without =
      report_of(bench.run({"identify", "--json"}, {"--without", "load_dependent_friction"}));
  for (const json& each : without["effects_added"]) {
    EXPECT_NE(each["effect"], "load_dependent_friction");
  }
  const json only = report_of(
      bench.run({"identify", "--json"}, {"--only", "load_dependent_friction,gear_ripple"}));
  ASSERT_EQ(only["effects_added"].size(), 1u);
  EXPECT_EQ(only["effects_added"][0]["effect"], "load_dependent_friction");
  const Outcome misspelt = bench.run({"identify"}, {"--without", "load_friction"});
  EXPECT_EQ(misspelt.exit_code, 2);
  EXPECT_NE(misspelt.err.find("no effect is called \"load_friction\""), std::string::npos);
}

// The effect that is there, of which the tolerance keeps the name back.
TEST(Identify, SaysThatTheToleranceRefuses) {
  const Bench bench;
  const json report = report_of(bench.run({"identify", "--json"}, {"--tolerance", "1"}));
  EXPECT_TRUE(report["effects_added"].empty());
  std::string reason;
  for (const json& each : report["rejected"]) {
    if (each["effect"] == "load_dependent_friction") reason = each["reason"];
  }
  EXPECT_NE(
      reason.find("changes the prediction by 0.735 rms (in its unit), which is less than the "),
      std::string::npos)
      << reason << report["rejected"];
  EXPECT_NE(reason.find("of the tolerance"), std::string::npos) << reason;
}

TEST(Identify, ResidualStopsBeforeTheSelection) {
  const Outcome outcome = Bench().run({"identify", "residual"}, {"--json"});
  EXPECT_EQ(outcome.exit_code, 1);
  const json report = report_of(outcome);
  EXPECT_EQ(report["verdict"], "unexplained");
  EXPECT_TRUE(report["effects_added"].empty());
  EXPECT_EQ(report["options"]["select"], false);
  EXPECT_EQ(report["before"], report["after"]);
}

// Two and a half seconds: not enough to hold anything out of a fit.
TEST(Identify, RefusesToTellFromAShortLog) {
  Bench bench;
  std::istringstream log(bench.place.text("log.csv"));
  std::string few, line;
  for (int i = 0; i <= 500 && std::getline(log, line); ++i) few += line + "\n";
  bench.place.write("log.csv", few);
  bench.place.write("rig.json",
                    with(bench.place.text("rig.json"), ",\n \"holdout_runs\": [\"run_4\"]", ""));
  const Outcome outcome = bench.run({"identify"}, {"--json", "--refined", "refined.json"});
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_EQ(report_of(outcome)["verdict"], "cannot_tell");
  EXPECT_FALSE(bench.place.has("refined.json"));
  EXPECT_NE(outcome.err.find("refined.json: not written"), std::string::npos) << outcome.err;
}

TEST(Identify, RefusesBadInput) {
  const Bench bench;
  struct Case {
    std::vector<std::string> words;
    const char* said;
  };
  const std::vector<Case> cases = {
      {{"identify", "log.csv", "--actuator", "actuator.json"}, "--rig is required"},
      {{"identify", "log.csv", "--rig", "rig.json"}, "--actuator is required"},
      {{"identify", "--rig", "rig.json", "--actuator", "actuator.json"}, "logs is required"},
      {{"identify", "absent.csv", "--rig", "rig.json", "--actuator", "actuator.json"},
       "absent.csv"},
      {{"identify", "log.csv", "--rig", "rig.json", "--actuator", "a.json", "--actuator", "b.json"},
       "--actuator: the rig has one joint"},
      {{"identify", "log.csv", "--rig", "rig.json", "--actuator", "actuator.json", "-o",
        "rig.json"},
       "rig.json"}};
  for (const Case& each : cases) {
    const Outcome outcome = bench.place.run(each.words);
    EXPECT_EQ(outcome.exit_code, 2) << testing::PrintToString(each.words);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(each.said), std::string::npos) << outcome.err;
  }
}

// Closed form: driving, torque on the load is that before the friction over 1 + k.
TEST(Identify, RefinedActuatorIsReadBackWithLessTorque) {
  const Bench bench;
  ASSERT_EQ(bench.run({"identify"}, {"--refined", "refined.json"}).exit_code, 0);
  const json effect = json::parse(bench.place.text("refined.json"))["effects"][0];
  EXPECT_EQ(effect["provenance"]["source"], "identified");
  const double k = effect["parameters"]["driving_coefficient"];
  EXPECT_NEAR(k, 0.14, kErrors * effect["standard_error"]["driving_coefficient"].get<double>());
  const Outcome compared =
      bench.place.run({"actuator", "mor", "refined.json", "--compare", "actuator.json", "--json"});
  ASSERT_EQ(compared.exit_code, 0) << compared.err;
  const json comparison = json::parse(compared.out);
  EXPECT_TRUE(io::conforms(comparison, "region_comparison")) << compared.out;
  const double from = comparison["from"]["figures"]["stall_torque_Nm"];
  const double to = comparison["to"]["figures"]["stall_torque_Nm"];
  EXPECT_NEAR(to, from / (1.0 + k), 1e-9 * from);
  EXPECT_NEAR(comparison["quadrants"][0]["worst_loss"]["change_Nm"].get<double>(), to - from,
              1e-9 * from);
  const Outcome region = bench.place.run({"actuator", "mor", "refined.json", "--json"});
  EXPECT_EQ(json::parse(region.out)["effects"], json({"load_dependent_friction (identified)"}));
}

// Oracle: /bin/sh takes the line apart into words, with which the program then does it.
TEST(Identify, NextLineIsWhatAShellTakes) {
  const Bench bench;
  const std::string stated = "stated " + kAwkwardName, refined = "refined " + kAwkwardName;
  bench.place.write(stated, bench.place.text("actuator.json"));
  const Outcome outcome = bench.place.run(
      {"identify", "log.csv", "--rig", "rig.json", "--actuator", stated, "--refined", refined});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto words = suggested_words(outcome.out, "next           torquewright");
  EXPECT_EQ(words, (std::vector<std::string>{"actuator", "mor", refined, "--compare", stated}));
  EXPECT_EQ(bench.place.run(words).exit_code, 0);
}

// Linux allows any bytes in a file's name, JSON only UTF-8 (RFC 8259, 8.1): U+FFFD stands for the
// others.
TEST(Identify, RefinedActuatorNamesALogWhoseNameIsNoText) {
  Bench bench;
  bench.logs = {"log\xff.csv"};
  bench.place.write("log\xff.csv", bench.place.text("log.csv"));
  const Outcome outcome = bench.run({"identify"}, {"--json", "--refined", "refined.json"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(report_of(outcome)["inputs"][0]["path"], "log\xEF\xBF\xBD.csv");
  const json refined = json::parse(bench.place.text("refined.json"));
  EXPECT_EQ(refined["effects"][0]["provenance"]["logs"][0]["path"], "log\xEF\xBF\xBD.csv");
}

// A document's texts are one line each: the name is written so that the document can be read.
TEST(Identify, RefinedActuatorNamesALogWhoseNameIsNoLine) {
  Bench bench;
  bench.logs = {"l\n2\xEF\xBF\xBE.csv"};
  bench.place.write(bench.logs[0], bench.place.text("log.csv"));
  const Outcome outcome = bench.run({"identify"}, {"--refined", "r.json", "-o", "i.json"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  const json refined = json::parse(bench.place.text("r.json"));
  EXPECT_EQ(refined["effects"][0]["provenance"]["logs"][0]["path"],
            "l\xEF\xBF\xBD"
            "2\xEF\xBF\xBD.csv");
  EXPECT_TRUE(bench.place.has("i.json"));
  EXPECT_EQ(bench.place.run({"actuator", "mor", "r.json"}).exit_code, 0);
}

// What no document can name is said before the work: then nothing at all is written.
TEST(Identify, RefusesARefinedActuatorThatCouldNotNameItsGearbox) {
  const Bench bench;
  const std::string folder = "a\nb";
  fs::create_directory(bench.place.path(folder));
  json actuator = json::parse(bench.place.text("actuator.json"));
  actuator["gearbox"] = {{"file", "gearbox.json"}};
  bench.place.write(folder + "/gearbox.json",
                    text_of(in_repository("specs/gearbox/d151_knee_result.json")));
  bench.place.write("actuator.json", "{}");
  bench.place.write(folder + "/actuator.json", actuator.dump());
  const Outcome outcome =
      bench.place.run({"identify", "log.csv", "--rig", "rig.json", "--actuator",
                       folder + "/actuator.json", "--refined", "r.json", "-o", "i.json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("r.json: cannot be written: it would name the file"),
            std::string::npos)
      << outcome.err;
  EXPECT_FALSE(bench.place.has("i.json"));
}

// What was assumed of an effect that is replaced is assumed no more; what was assumed of another is
// found in its new place. Oracle: where they stand in the document that is written.
TEST(Identify, RefinedActuatorAssumesNothingOfAnEffectThatItReplaces) {
  const Bench bench;
  json actuator = json::parse(bench.place.text("actuator.json"));
  actuator["effects"] = {
      {{"effect", "load_dependent_friction"},
       {"parameters", {{"driving_coefficient", 0.028}, {"backdriving_coefficient", 0.02}}}},
      {{"effect", "viscous_friction"}, {"parameters", {{"viscous_Nm_s_rad", 1e-6}}}}};
  actuator["assumed"] = {"/motor/resistance_ohm", "/effects/0/parameters/driving_coefficient",
                         "/effects/0", "/effects/1/parameters/viscous_Nm_s_rad", "/effects"};
  bench.place.write("actuator.json", actuator.dump());
  const Outcome outcome = bench.run({"identify"}, {"--refined", "r.json"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  const json refined = json::parse(bench.place.text("r.json"));
  EXPECT_EQ(refined["effects"][0]["effect"], "viscous_friction");
  EXPECT_EQ(refined["assumed"],
            json({"/motor/resistance_ohm", "/effects/0/parameters/viscous_Nm_s_rad", "/effects"}));
}

// The run's name stands in the page and in documents.
TEST(Identify, RefusesARunWhoseNameIsNoLineOfText) {
  const Bench bench;
  bench.place.write("log.csv", with(bench.place.text("log.csv"), "run_1", "run\xE9"));
  const Outcome outcome = bench.run({"identify"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("the run's name holds the byte 0xE9, which is not UTF-8"),
            std::string::npos)
      << outcome.err;
}

TEST(Identify, ReportIsAPageThatHoldsAll) {
  Bench bench;
  bench.place.write("rig.json", with(bench.place.text("rig.json"), "knee on the bench",
                                     "<b>knee</b> & </section><script>"));
  const Outcome outcome = bench.run({"identify"}, {"--report", "report.html"});
  if (outcome.err.find("gnuplot") != std::string::npos) GTEST_SKIP() << "gnuplot is not installed";
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string page = bench.place.text("report.html");
  EXPECT_EQ(fault_in(page), "");
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_EQ(page.find("<link"), std::string::npos);
  EXPECT_NE(page.find("&lt;b&gt;knee&lt;/b&gt; &amp; "), std::string::npos);
  std::size_t pictures = 0;
  for (std::size_t at = page.find("<svg"); at != std::string::npos;
       at = page.find("<svg", at + 1)) {
    ++pictures;
  }
  // Waterfall, runs, coordinates, regions; two of what is left of each of the four runs.
  EXPECT_EQ(pictures, 4u + 2u * 4u);
}

// The loop closes: what the log showed turns the verdict on a motion. Stall torque by hand: mesh
// without loss 22.5 Nm, with the truth's friction of 0.14 of the load 22.5/1.14 = 19.8 Nm; the lift
// asks for 20.2 Nm.
TEST(Identify, RefinedActuatorTurnsTheVerdictOnAMotion) {
  const Bench bench;
  ASSERT_EQ(bench.run({"identify"}, {"--refined", "refined.json"}).exit_code, 0);
  const auto verdict = [&](const std::string& actuator) {
    return bench.place
        .run({"actuator", "check", in_repository("specs/trajectory/bench_lift.csv"), "--joint",
              "knee=" + actuator, "--torque-includes-inertia"})
        .exit_code;
  };
  EXPECT_EQ(verdict("actuator.json"), 0);
  EXPECT_EQ(verdict("refined.json"), 1);
}

}  // namespace
}  // namespace torquewright::cli_test
