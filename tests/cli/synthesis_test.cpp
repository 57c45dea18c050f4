// SPDX-License-Identifier: Apache-2.0
// `gearbox optimize` of a problem with `synthesis`, as a user runs it, and what is done with its
// result.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/documents/schema.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

/// Eight lines and a few choices, so that it takes a second.
const char* const kEightLines = R"({"kind": "gearbox_problem", "version": 1,
 "topology": "3k",
 "target_ratio": 20, "ratio_tolerance": 0,
 "rotor_inner_diameter_mm": 79.4, "module_mm": 0.7, "planet_count": 3,
 "min_teeth": {"sun": 50, "planet_1": 20, "planet_2": 16},
 "load": {"output_torque_Nm": 120, "cycles": 1000000},
 "synthesis": {}})";

// Oracle: evaluate and strength of the same program, which know nothing of the search.
TEST(Synthesis, IsWhatStrengthAndActuatorTake) {
  const Workplace place;
  place.write("gears.json", kEightLines);
  const Outcome found = place.run({"gearbox", "optimize", "gears.json", "-o", "result.json"});
  EXPECT_EQ(found.exit_code, 0) << found.out << found.err;
  EXPECT_EQ(found.err, "");
  EXPECT_TRUE(found.out.starts_with("optimal: proved within ")) << found.out;
  EXPECT_NE(found.out.find("\nHeld fixed: one module for both layers"), std::string::npos);
  EXPECT_NE(found.out.find("/materials/steel"), std::string::npos);  // among what is assumed
  const json result = json::parse(place.text("result.json"));
  EXPECT_TRUE(io::conforms(result, "gearbox_result"));
  EXPECT_LE(result["bound"], result["objective"]);
  EXPECT_LE(result["gap"], 0.001 + 1e-12);
  const Outcome strength = place.run({"gearbox", "strength", "result.json"});
  EXPECT_EQ(strength.exit_code, 0) << strength.out << strength.err;
  EXPECT_NE(strength.out.find("120 Nm at the joint: borne"), std::string::npos) << strength.out;
}

// Oracle: a proof that shares no formula with the search.
TEST(Synthesis, IsVerified) {
  const Workplace place;
  place.write("gears.json", kEightLines);
  const Outcome found =
      place.run({"gearbox", "optimize", "gears.json", "-o", "result.json", "--verify"});
  EXPECT_EQ(found.exit_code, 0) << found.out << found.err;
  EXPECT_NE(
      found.out.find("\naccepted: 51/25/20/102/96 with 3 planets, module 0.7 mm satisfies all "
                     "constraints, bears the load and weighs "),
      std::string::npos)
      << found.out;
  const Outcome verdict = place.run({"gearbox", "verify", "result.json", "--json"});
  EXPECT_EQ(verdict.exit_code, 0) << verdict.out;
  EXPECT_EQ(verdict.err, "");
  EXPECT_TRUE(io::conforms(json::parse(verdict.out), "verification_report"));
  json forged = json::parse(place.text("result.json"));
  const double bound = forged["bound"];
  forged["bound"] = forged["certificate"]["sized_claims"][0]["bound"] = 1.0005 * bound;
  forged["gap"] = 1.0 - 1.0005 * bound / forged["objective"].get<double>();
  forged["problem"]["min_teeth"]["sun"] = 30;
  place.write("forged.json", forged.dump());
  const Outcome refused = place.run({"gearbox", "verify", "forged.json"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_TRUE(refused.out.starts_with("rejected: the result is not proved:\n")) << refused.out;
}

// One screen of a terminal of 40 rows; the rest by --all.
TEST(Synthesis, AnswersOnOneScreen) {
  const Workplace place;
  place.write("gears.json", kEightLines);
  const Outcome screen = place.run({"gearbox", "optimize", "gears.json"});
  EXPECT_EQ(screen.exit_code, 0) << screen.err;
  EXPECT_LE(std::count(screen.out.begin(), screen.out.end(), '\n'), 30) << screen.out;
  for (const char* line :
       {"\n1. sun ", "\n  ratio             20 sun over output\n", "\n  efficiency ",
        "\n  strength          the teeth bear 120 Nm at the output, where 120 Nm act",
        "\n  face widths       layer 1 ", "\n  tightest ",
        "\nnext: torquewright gearbox optimize gears.json --all"}) {
    EXPECT_NE(screen.out.find(line), std::string::npos) << line << screen.out;
  }
  const Outcome all = place.run({"gearbox", "optimize", "gears.json", "--all"});
  EXPECT_EQ(all.exit_code, 0);
  for (const char* line : {"\n  gear           teeth", "\n  constraint    margin",
                           "\nSearch: ", "\nBound that nothing beats: "}) {
    EXPECT_NE(all.out.find(line), std::string::npos) << line;
    EXPECT_EQ(screen.out.find(line), std::string::npos) << line;
  }
}

// "Optimal" is said with what the teeth bear, in the one line of -q too.
TEST(Synthesis, QuietAnswersSayWhatTheTeethBear) {
  const Workplace place;
  place.write("gears.json", kEightLines);
  const std::string sized = place.run({"gearbox", "optimize", "gears.json", "-q"}).out;
  EXPECT_TRUE(sized.starts_with("optimal: proved within ")) << sized;
  EXPECT_NE(sized.find("the teeth bear 120 Nm at the output, where 120 Nm act"), std::string::npos)
      << sized;
  const std::string plain =
      place.run({"gearbox", "optimize", in_specs("gearbox/d151_knee.json"), "-q"}).out;
  EXPECT_TRUE(
      plain.starts_with("optimal: proved, nothing is better; 44/44/32/132/120: does not "
                        "bear the load: the teeth bear "))
      << plain;
  for (const std::string& answer : {sized, plain}) {
    EXPECT_EQ(std::count(answer.begin(), answer.end(), '\n'), 1) << answer;
  }
}

// Oracle: strength of the same program.
TEST(Synthesis, SizesASingleStage) {
  const Workplace place;
  json stage = json::parse(kEightLines);
  stage["topology"] = "planetary";
  stage["target_ratio"] = 5;
  stage["min_teeth"] = {{"sun", 24}, {"planet", 20}};
  place.write("stage.json", stage.dump());
  const Outcome found = place.run({"gearbox", "optimize", "stage.json", "-o", "result.json"});
  EXPECT_EQ(found.exit_code, 0) << found.out << found.err;
  EXPECT_NE(found.out.find("\n  face width "), std::string::npos) << found.out;
  EXPECT_TRUE(io::conforms(json::parse(place.text("result.json")), "gearbox_result"));
  const Outcome strength = place.run({"gearbox", "strength", "result.json"});
  EXPECT_NE(strength.out.find("120 Nm at the joint: borne"), std::string::npos) << strength.out;
  stage["synthesis"]["layer_2_module_mm"] = 0.6;
  place.write("stage.json", stage.dump());
  EXPECT_EQ(place.run({"gearbox", "optimize", "stage.json"}).err,
            "stage.json#/synthesis/layer_2_module_mm: the topology \"planetary\" has one layer "
            "only\n");
}

/// 14:1 that leaves the topology open.
const char* const kOpenTopology = R"({"kind": "gearbox_problem", "version": 1,
 "topology": "any", "target_ratio": 14, "ratio_tolerance": 0,
 "rotor_inner_diameter_mm": 60, "module_mm": 0.5, "planet_count": 3,
 "min_teeth": {"sun": 14, "planet_1": 20, "planet_2": 14, "planet": 14},
 "load": {"output_torque_Nm": 40}, "synthesis": {"gap": 0.005}})";

// Oracle: the same program with the topology that it has chosen; strength, drawing and actuators
// read the result as one of that topology.
TEST(Synthesis, ChoosesTheTopologyAndSaysWhatTheOthersHave) {
  const Workplace place;
  place.write("open.json", kOpenTopology);
  const Outcome found =
      place.run({"gearbox", "optimize", "open.json", "-o", "result.json", "--draw", "gears.svg"});
  EXPECT_EQ(found.exit_code, 0) << found.out << found.err;
  EXPECT_NE(found.out.find(", nothing of 4 topologies is lighter than "), std::string::npos);
  EXPECT_NE(found.out.find("\nTopologies:\n  3k                "), std::string::npos) << found.out;
  EXPECT_NE(found.out.find("\n  planetary         none, proved: no teeth meet "), std::string::npos)
      << found.out;
  const json result = json::parse(place.text("result.json"));
  EXPECT_TRUE(io::conforms(result, "gearbox_result"));
  ASSERT_EQ(result["topologies"].size(), 4U);
  const std::string chosen = result["problem"]["topology"];
  EXPECT_EQ(chosen, "compound");
  for (const json& each : result["topologies"]) {
    const json& own = each["objective"];
    EXPECT_EQ(each["topology"] == chosen, own == result["objective"]) << each;
    EXPECT_TRUE(own.is_null() || own >= result["objective"]) << each;
  }
  const Outcome strength = place.run({"gearbox", "strength", "result.json"});
  EXPECT_NE(strength.out.find("40 Nm at the joint: borne"), std::string::npos)
      << strength.out << strength.err;
  EXPECT_EQ(place.run({"gearbox", "drawing", "result.json", "--dxf", "gears.dxf"}).exit_code, 0);
  EXPECT_NE(place.text("gears.svg").find("Layer 1: sun, planets 1<"), std::string::npos);
  json stated = result["problem"];
  place.write("stated.json", stated.dump());
  place.run({"gearbox", "optimize", "stated.json", "-o", "again.json"});
  EXPECT_EQ(json::parse(place.text("again.json"))["designs"], result["designs"]);
}

TEST(Synthesis, RefusesATopologyThatNothingCloses) {
  const Workplace place;
  place.write("open.json", kOpenTopology);
  EXPECT_EQ(place.run({"gearbox", "evaluate", "open.json", "--teeth", "20,40,20"}).err,
            "open.json#/topology: \"any\" leaves it open, which optimize, pareto and design of a "
            "problem with /synthesis close; state one\n");
  json plain = json::parse(kOpenTopology);
  plain.erase("synthesis");
  plain["topology"] = "compound";
  plain["min_teeth"].erase("planet");
  plain.merge_patch(json{{"constraints", "buildable"},
                         {"objective", "hollow_shaft"},
                         {"min_carrier_clearance_rad", 0}});
  place.write("plain.json", plain.dump());
  EXPECT_EQ(place.run({"gearbox", "optimize", "plain.json"}).err,
            "plain.json#/synthesis: missing; the topology \"compound\" is searched with it only "
            "({} will do)\n");
}

// Each of the two can be met, but not both. Oracle: the same problem without either.
TEST(Synthesis, NamesFloorsThatConflict) {
  const Workplace place;
  json asked = json::parse(kEightLines);
  place.write("gears.json", asked.dump());
  ASSERT_EQ(place.run({"gearbox", "optimize", "gears.json", "-o", "free.json"}).exit_code, 0);
  const json free = json::parse(place.text("free.json"))["designs"][0];
  const double least_kg = free["mass_kg"], backward = free["backward_efficiency"];
  asked["max_mass_kg"] = 1.002 * least_kg;
  asked["min_backward_efficiency"] = backward + 0.01;
  asked["min_hollow_shaft_diameter_mm"] = 1;
  place.write("gears.json", asked.dump());
  const Outcome both = place.run({"gearbox", "optimize", "gears.json", "-o", "both.json"});
  EXPECT_EQ(both.exit_code, 1) << both.out << both.err;
  EXPECT_NE(both.out.find(
                "\nThese conflict, and would not without any one of them:\n  load: Without load "),
            std::string::npos)
      << both.out;
  EXPECT_NE(both.out.find("\n  backward_efficiency: Without min_backward_efficiency there is "),
            std::string::npos)
      << both.out;
  const json result = json::parse(place.text("both.json"));
  EXPECT_TRUE(io::conforms(result, "gearbox_result"));
  ASSERT_EQ(result["conflict"].size(), 3U);  // The load is heavy too.
  EXPECT_EQ(result["conflict"][2]["constraint"], "mass");
  asked.erase("max_mass_kg");
  place.write("gears.json", asked.dump());
  EXPECT_EQ(place.run({"gearbox", "optimize", "gears.json"}).exit_code, 0);
}

TEST(Synthesis, EndsWithABoundAndRefusesWhatItDoesNotKnow) {
  const Workplace place;
  place.write("gears.json", kEightLines);
  const Outcome ended =
      place.run({"gearbox", "optimize", "gears.json", "--max-nodes", "10", "--json"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_EQ(json::parse(ended.out)["status"], "limit");
  EXPECT_EQ(place.run({"gearbox", "optimize", "gears.json", "--top", "2"}).exit_code, 2);
  json wrong = json::parse(kEightLines);
  wrong["synthesis"] = {{"min_profile_shift", 0.5}, {"max_profile_shift", 0.1}};
  place.write("gears.json", wrong.dump());
  EXPECT_EQ(place.run({"gearbox", "optimize", "gears.json"}).err,
            "gears.json#/synthesis/min_profile_shift: 0.5 is more than "
            "/synthesis/max_profile_shift, 0.1\n");
  wrong = json::parse(kEightLines);
  wrong.erase("load");
  place.write("gears.json", wrong.dump());
  EXPECT_EQ(place.run({"gearbox", "optimize", "gears.json"}).err,
            "gears.json#/load/output_torque_Nm: missing; synthesis needs it\n");
}

}  // namespace
}  // namespace torquewright::cli_test
