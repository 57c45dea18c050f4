// SPDX-License-Identifier: Apache-2.0
#include "gearbox/problem_spec.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "io/documents/document.hpp"

namespace torquewright::gearbox {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

const fs::path kSpecs = fs::path(TORQUEWRIGHT_SOURCE_DIR) / "specs" / "gearbox";

json document_of(const char* file) {
  return io::read_document(kSpecs / file, "gearbox_problem").root;
}

Problem problem_of(const json& root) {
  return read_problem(io::check_document(root, "gearbox_problem", "f", ""));
}

/// What the problem is refused with; empty if it is not.
std::string refusal(const json& root) {
  try {
    problem_of(root);
    return "";
  } catch (const io::SpecError& error) {
    return error.what();
  }
}

// Oracle: the document, by eye.
TEST(ReadProblem, KeepsEveryNumberAsItWasWritten) {
  const Problem problem = problem_of(document_of("d151_knee.json"));
  EXPECT_EQ(problem.name, "D151 knee");
  EXPECT_EQ(problem.topology, "3k");
  EXPECT_EQ(problem.target_ratio, 20);
  EXPECT_EQ(problem.ratio_tolerance, 0);
  EXPECT_EQ(problem.rotor_inner_diameter_mm / problem.module_mm.front(), Rational(397, 3));
  EXPECT_EQ(problem.module_mm, std::vector<Rational>({Rational(3, 5)}));
  EXPECT_EQ(problem.planet_count, std::vector<std::int64_t>({4}));
  EXPECT_EQ(problem.min_teeth,
            (std::map<std::string, std::int64_t>{{"sun", 40}, {"planet_1", 40}, {"planet_2", 30}}));
  EXPECT_EQ(problem.min_carrier_clearance_rad, Rational(13, 50));
  EXPECT_EQ(problem.constraints, ConstraintSet::kPaper);
  EXPECT_EQ(problem.objective, Objective::kPaperCost);
  EXPECT_EQ(problem.friction_coefficient, Rational(2, 25));
  EXPECT_EQ(problem.load_output_torque_Nm, 320);
  EXPECT_EQ(problem.assumed.size(), 3u);
}

TEST(ReadProblem, LeavesOutWhatIsNotGiven) {
  json root = document_of("d151_knee.json");
  for (const char* key : {"name", "ratio_tolerance", "friction_coefficient", "load", "assumed"}) {
    root.erase(key);
  }
  const io::Document document = io::check_document(root, "gearbox_problem", "a/knee.json", "");
  const Problem problem = read_problem(document);
  EXPECT_EQ(problem.name, "knee");
  EXPECT_EQ(problem.ratio_tolerance, 0);
  EXPECT_EQ(problem.friction_coefficient, std::nullopt);
  EXPECT_EQ(problem.load_output_torque_Nm, std::nullopt);
  EXPECT_EQ(problem.ring_outer_diameter_mm, std::nullopt);
  EXPECT_EQ(problem.ring_wall_mm, std::nullopt);
  EXPECT_EQ(problem.density_kg_m3, std::nullopt);
  EXPECT_EQ(problem.min_contact_ratio, Rational(6, 5));
  EXPECT_EQ(problem.min_neighbour_clearance_mm, 0);
  EXPECT_TRUE(problem.sun_under_second_layer);
  EXPECT_TRUE(problem.face_width_mm.empty());
  EXPECT_TRUE(problem.assumed.empty());
}

TEST(ReadProblem, ReadsEveryOptionalKey) {
  json root = document_of("finger_joint.json");
  root.update({{"min_contact_ratio", 1.1},
               {"min_neighbour_clearance_mm", 0.15},
               {"ring_outer_diameter_mm", 19.5},
               {"ring_wall_mm", 0.45},
               {"sun_under_second_layer", false},
               {"cutter",
                {{"hob_tip_radius", 0.25},
                 {"hob_addendum", 1.3},
                 {"shaper_tip_radius", 0.2},
                 {"shaper_addendum", 1.15},
                 {"shaper_teeth", 25}}},
               {"hollow_shaft_wall_mm", 0.25}});
  const Problem problem = problem_of(root);
  EXPECT_EQ(problem.min_contact_ratio, Rational(11, 10));
  EXPECT_EQ(problem.min_neighbour_clearance_mm, Rational(3, 20));
  EXPECT_EQ(problem.ring_outer_diameter_mm, Rational(39, 2));
  EXPECT_EQ(problem.ring_wall_mm, Rational(9, 20));
  EXPECT_FALSE(problem.sun_under_second_layer);
  EXPECT_EQ(problem.hollow_shaft_wall_mm, Rational(1, 4));
  EXPECT_EQ(problem.cutters.hob_tip_radius, Rational(1, 4));
  EXPECT_EQ(problem.cutters.shaper_tip_radius, Rational(1, 5));
  EXPECT_EQ(problem.cutters.shaper_teeth, 25);
  EXPECT_EQ(problem.cutters.hob_addendum, Rational(13, 10));
  EXPECT_EQ(problem.cutters.shaper_addendum, Rational(23, 20));
  EXPECT_EQ(problem.face_width_mm,
            (std::map<std::string, Rational>{{"layer_1", 2}, {"layer_2", 3}}));
  EXPECT_EQ(problem.density_kg_m3, 7850);
  EXPECT_EQ(problem.rotor_inertia_kg_m2, Rational(1, 5000000));
  EXPECT_EQ(problem.constraints, ConstraintSet::kBuildable);
  EXPECT_EQ(problem.objective, Objective::kMass);
}

// Oracle: another program's full rounding of a shaper of 12 teeth, 0.25011.
TEST(ReadProblem, RefusesARoundingThatTheShaperHasNoRoomFor) {
  json root = document_of("finger_joint.json");
  root["cutter"] = {{"shaper_teeth", 12}, {"shaper_tip_radius", 0.25}};
  EXPECT_EQ(refusal(root), "");
  root["cutter"]["shaper_tip_radius"] = 0.251;
  EXPECT_EQ(refusal(root),
            "f#/cutter/shaper_tip_radius: 0.251 does not fit on the tip of a shaper of 12 teeth; "
            "at most 0.25");
  root["cutter"] = {{"hob_tip_radius", 0.39}};
  EXPECT_NE(refusal(root), "");
}

// Oracle: half the angle of a shaper's tooth at its tip, pi/2q + inv(20 deg) - inv(acos(q cos(20
// deg)/(q + 2 h))): of 11 teeth 0.0012 at h = 1.37 and -0.00006 at 1.38. ISO 53 profile D is 1.4
// and 0.39.
TEST(ReadProblem, RefusesAddendaThatMakeNoTool) {
  const auto refused = [](const json& cutter) {
    json root = document_of("finger_joint.json");
    root["cutter"] = cutter;
    return refusal(root);
  };
  EXPECT_EQ(refused({{"hob_tip_radius", 0.39}, {"hob_addendum", 1.4}}), "");
  EXPECT_NE(refused({{"hob_tip_radius", 0.391}, {"hob_addendum", 1.4}}), "");
  EXPECT_NE(refused({{"hob_addendum", 1.41}}), "");
  EXPECT_NE(refused({{"hob_addendum", 1.0}}), "");  // No clearance is left.
  EXPECT_EQ(refused({{"hob_tip_radius", 0.39}}),
            "f#/cutter/hob_tip_radius: 0.39 is more than the 0.38 of a hob of addendum 1.25; state "
            "/cutter/hob_addendum too");
  EXPECT_EQ(refused({{"shaper_teeth", 11}, {"shaper_addendum", 1.37}}), "");
  EXPECT_EQ(
      refused({{"shaper_teeth", 11}, {"shaper_addendum", 1.38}}),
      "f#/cutter/shaper_addendum: a shaper of 11 teeth is pointed before an addendum of 1.38");
}

TEST(ReadProblem, SortsLists) {
  json root = document_of("d151_knee.json");
  root["module_mm"] = {0.8, 0.5, 0.6};
  root["planet_count"] = {5, 3};
  const Problem problem = problem_of(root);
  EXPECT_EQ(problem.module_mm,
            std::vector<Rational>({Rational(1, 2), Rational(3, 5), Rational(4, 5)}));
  EXPECT_EQ(problem.planet_count, std::vector<std::int64_t>({3, 5}));
}

TEST(ReadProblem, KnowsEveryObjective) {
  json root = document_of("finger_joint.json");
  const std::pair<const char*, Objective> objectives[] = {
      {"paper_cost", Objective::kPaperCost},
      {"mass", Objective::kMass},
      {"hollow_shaft", Objective::kHollowShaft},
      {"forward_efficiency", Objective::kForwardEfficiency},
      {"backward_efficiency", Objective::kBackwardEfficiency},
      {"reflected_inertia", Objective::kReflectedInertia}};
  for (const auto& [word, objective] : objectives) {
    root["objective"] = word;
    EXPECT_EQ(problem_of(root).objective, objective);
  }
}

TEST(ReadProblem, AcceptsEverySpec) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(kSpecs)) {
    const json root = json::parse(std::ifstream(entry.path()));
    if (root["kind"] != "gearbox_problem") continue;
    EXPECT_EQ(refusal(root), "") << entry.path();
    ++count;
  }
  EXPECT_GE(count, 5);
}

TEST(ReadProblem, RefusesThePaperForAPlanetary) {
  json root = document_of("d110a_ankle.json");
  root["constraints"] = "paper";
  root["objective"] = "paper_cost";
  EXPECT_EQ(refusal(root),
            "f#/constraints: \"paper\" does not go with the topology \"planetary\": equations "
            "(2)-(9) describe the 3k gearbox only; use \"buildable\"\n"
            "f#/objective: \"paper_cost\" does not go with the topology \"planetary\": equation "
            "(1) describes the 3k gearbox only; use \"hollow_shaft\", \"mass\", "
            "\"forward_efficiency\", \"backward_efficiency\" or \"reflected_inertia\"");
}

TEST(ReadProblem, RefusesMinimaOfOtherGears) {
  json root = document_of("d110a_ankle.json");
  root["min_teeth"] = {{"sun", 18}, {"planet_1", 18}};
  EXPECT_EQ(refusal(root),
            "f#/min_teeth/planet_1: the topology \"planetary\" has none, only sun, planet\n"
            "f#/min_teeth/planet: missing; the topology \"planetary\" has sun, planet");
  root = document_of("d151_knee.json");
  root["min_teeth"] = {{"sun", 18}, {"planet_1", 18}, {"planet", 18}};
  EXPECT_EQ(refusal(root),
            "f#/min_teeth/planet: the topology \"3k\" has none, only sun, planet_1, planet_2\n"
            "f#/min_teeth/planet_2: missing; the topology \"3k\" has sun, planet_1, planet_2");
}

TEST(ReadProblem, RefusesFaceWidthsOfOtherLayers) {
  json root = document_of("d110a_ankle.json");
  root["face_width_mm"] = {{"layer_1", 5}, {"layer_2", 5}};
  EXPECT_EQ(refusal(root),
            "f#/face_width_mm/layer_2: the topology \"planetary\" has none, only layer_1");
  root = document_of("d151_knee.json");
  root["face_width_mm"] = {{"layer_1", 5}};
  EXPECT_EQ(refusal(root),
            "f#/face_width_mm/layer_2: missing; the topology \"3k\" has layer_1, layer_2");
}

TEST(ReadProblem, RefusesAnObjectiveWithoutItsValues) {
  json root = document_of("knee_choices.json");
  root.erase("friction_coefficient");
  root.erase("assumed");
  for (const std::string objective : {"forward_efficiency", "backward_efficiency"}) {
    root["objective"] = objective;
    EXPECT_EQ(refusal(root),
              "f#/friction_coefficient: missing; the objective \"" + objective + "\" needs it");
  }
  for (const std::string objective : {"mass", "reflected_inertia"}) {
    root["objective"] = objective;
    EXPECT_EQ(refusal(root), "f#/face_width_mm: missing; the objective \"" + objective +
                                 "\" needs it\nf#/materials/density_kg_m3: missing; the objective "
                                 "\"" +
                                 objective + "\" needs it");
  }
  root["objective"] = "hollow_shaft";
  EXPECT_EQ(refusal(root), "");
}

TEST(ReadProblem, RefusesAValueTwiceInAList) {
  json root = document_of("d151_knee.json");
  root["module_mm"] = {0.6, 0.5, 0.6};
  root["planet_count"] = {3, 3};
  EXPECT_EQ(refusal(root),
            "f#/module_mm/2: 0.6 stands twice in this list; keep one\n"
            "f#/planet_count/1: 3 stands twice in this list; keep one");
}

TEST(ReadProblem, SaysWhereTheProblemStands) {
  json root = document_of("d110a_ankle.json");
  root["constraints"] = "paper";
  try {
    read_problem(io::check_document(root, "gearbox_problem", "result.json", "/problem"));
    FAIL();
  } catch (const io::SpecError& error) {
    EXPECT_EQ(error.faults().front().path, "/problem/constraints");
  }
}

}  // namespace
}  // namespace torquewright::gearbox
