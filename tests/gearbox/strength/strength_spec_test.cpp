// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/strength_spec.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "gearbox/constraints/existence.hpp"
#include "gearbox/strength/strength_table.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::gearbox {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

const fs::path kSpecs = fs::path(TORQUEWRIGHT_SOURCE_DIR) / "specs" / "gearbox";

json ankle_document() {
  json root = io::read_document(kSpecs / "d110a_strength.json", "gear_strength").root;
  root["gearbox"]["teeth"] = {{"sun", 21}, {"planet", 63}, {"ring", 147}};
  return root;
}

/// What the ankle's document is refused with once it is changed by a JSON merge patch.
std::string refusal(const json& patch) {
  json root = ankle_document();
  root.merge_patch(patch);
  try {
    strength_of(io::check_document(root, "gear_strength", (kSpecs / "f").string(), ""));
    return "";
  } catch (const io::SpecError& error) {
    const std::string text = error.what();
    return text.substr(text.find('#'));
  }
}

// Oracle: the document, by eye.
TEST(ReadStrength, KeepsEveryNumber) {
  const ReadStrength read = read_strength(kSpecs / "d110a_strength.json");
  const StrengthCase& strength = read.strength;
  EXPECT_EQ(read.name, "D110A ankle");
  EXPECT_EQ(strength.train.teeth, (std::vector<std::int64_t>{18, 54, 126}));
  EXPECT_EQ(strength.train.planet_count, 3);
  EXPECT_EQ(strength.train.module_mm, .6);
  EXPECT_EQ(strength.train.face_width_mm, std::vector<double>{10});
  EXPECT_EQ(strength.material.treatment, Treatment::kCaseHardened);
  EXPECT_EQ(strength.material.bending_endurance_MPa, 425);
  EXPECT_EQ(strength.material.contact_endurance_MPa, 1500);
  EXPECT_EQ(strength.factors.load_sharing, 1.1);
  EXPECT_EQ(strength.factors.face_load_root, 1.2);
  EXPECT_EQ(strength.factors.face_load_flank, 1.3);
  EXPECT_EQ(strength.factors.alternating_bending, .7);
  EXPECT_EQ(strength.cycles, 10000);
  EXPECT_EQ(strength.demanded_root_safety, 1.4);
  EXPECT_EQ(strength.demanded_flank_safety, 1);
  EXPECT_EQ(read.ring_space_mm, 90);
}

TEST(ReadStrength, TakesTheFirstDesignOfAResult) {
  const ReadStrength read = read_strength(kSpecs / "d151_strength.json");
  EXPECT_EQ(read.strength.train.topology, "3k");
  EXPECT_EQ(read.strength.train.teeth, (std::vector<std::int64_t>{44, 44, 32, 132, 120}));
  EXPECT_EQ(read.strength.train.planet_count, 4);
  EXPECT_EQ(read.documents.size(), 2u);
}

TEST(ReadStrength, RefusesWhatDoesNotFit) {
  EXPECT_EQ(refusal(json::object()), "");
  EXPECT_EQ(
      refusal({{"face_width_mm", {{"layer_2", 5}}}}),
      "#/face_width_mm/layer_2: is for 3k, 3k_b, compound trains; a planetary stage has one layer");
  EXPECT_EQ(
      refusal({{"material", {{"treatment", "through_hardened"}}}}),
      "#/material/yield_MPa: missing; the static strength of through-hardened teeth depends on "
      "it");
  EXPECT_EQ(refusal({{"rim_mm", {{"sun", .7}, {"ring", 1.1}}}}), "");
  EXPECT_EQ(refusal({{"rim_mm", {{"sun", .5 * 2.25 * .6}}}}).substr(0, 21),
            "#/rim_mm/sun: too thi");
  EXPECT_EQ(refusal({{"rim_mm", {{"ring", 1.75 * .6}}}}).substr(0, 22), "#/rim_mm/ring: too thi");
  EXPECT_EQ(refusal({{"rim_mm", {{"planet_2", 2}}}}),
            "#/rim_mm/planet_2: the topology \"planetary\" has no such gear");
  EXPECT_EQ(
      refusal({{"gearbox", {{"layer_2_module_mm", .7}}}}),
      "#/gearbox/layer_2_module_mm: is for 3k, 3k_b, compound trains; \"planetary\" has one layer");
  EXPECT_EQ(refusal({{"gearbox", {{"teeth", {{"ring", nullptr}}}}}}),
            "#/gearbox/teeth/ring: missing; the topology \"planetary\" has it");
  EXPECT_EQ(refusal({{"gearbox", {{"topology", "3k"}}}, {"face_width_mm", {{"layer_2", 5}}}}),
            "#/gearbox/teeth/planet_1: missing; the topology \"3k\" has it");
  EXPECT_EQ(refusal({{"gearbox", {{"teeth", {{"ring", 150}}}}}}),
            "#/gearbox: planet_ring do not mesh for teeth 21,63,150: it does not fit the centre "
            "distance of sun and planet");
  EXPECT_EQ(
      refusal({{"gearbox", {{"teeth", {{"sun", 12}, {"planet", 36}, {"ring", 84}}}}}}),
      "#/gearbox: sun_planet do not mesh for teeth 12,36,84: contact would reach inside a base "
      "circle (undercut)");
  EXPECT_EQ(refusal({{"gearbox", {{"teeth", {{"sun", 6}, {"planet", 18}, {"ring", 42}}}}}}),
            "#/gearbox: sun_planet do not mesh for teeth 6,18,42: stresses are computed for eight "
            "teeth and more");
}

// Oracles, by hand: 168 teeth are shared by 8 planets, of which 2 a sin(pi/8) - d_a =
// .6 (84 sin(22.5 deg) - 65) = -19.7128 mm is left, and not by 5. A sun of 12 teeth with x = 1.2
// and a planet with -0.6 work at 26.15 degrees, the sun's tip circle is 16.3101 modules wide, and
// s_a = d_a ((pi/2 + 2 x tan(alpha))/z + inv(alpha) - inv(alpha_a)) = -0.3101 modules there.
TEST(ReadStrength, RefusesWhatCannotExist) {
  EXPECT_EQ(refusal({{"gearbox", {{"planet_count", 8}}}}).substr(0, 52),
            "#/gearbox: neighbour_clearance.layer_1: -19.71 mm be");
  EXPECT_EQ(refusal({{"gearbox", {{"planet_count", 5}}}}).substr(0, 46),
            "#/gearbox: equal_spacing: 3 teeth left over wh");
  const json pointed = {{"teeth", {{"sun", 12}, {"planet", 36}, {"ring", 84}}},
                        {"profile_shift", {{"sun", 1.2}, {"planet", -.6}}}};
  EXPECT_EQ(refusal({{"gearbox", pointed}}).substr(0, 48),
            "#/gearbox: tip_thickness.sun: -0.1861 mm of toot");
}

// Oracle: eq. (8) in another language: .6 x 0.29129 mm for 63 in 147 teeth, -0.006 modules for 22
// in 49.
TEST(ReadStrength, RefusesAHobThatLeavesTooLittleInvolute) {
  EXPECT_EQ(refusal({{"cutter", {{"hob_tip_radius", .291}, {"shaper_tip_radius", .2}}}}), "");
  EXPECT_EQ(refusal({{"cutter", {{"hob_tip_radius", .292}}}}).substr(0, 47),
            "#/gearbox: root_form.hob.planet_ring: 0.1748 mm");
  const std::vector<ConstraintReport> narrow =
      what_cannot_exist({"planetary", {5, 22, 49}, {0, 0, 0}, 2, .6, {}});
  const auto form = std::find_if(narrow.begin(), narrow.end(), [](const ConstraintReport& each) {
    return each.name == "root_form.hob.planet_ring";
  });
  ASSERT_NE(form, narrow.end());
  EXPECT_NEAR(form->value, -.6 * .0058, .6 * .0006);
}

// The cutter is that of the result's problem, unless the document states another; then it says so.
TEST(ReadStrength, TakesTheCutterOfTheResult) {
  const torquewright::test::ScratchFolder folder;
  json result = io::read_document(kSpecs / "d151_knee_result.json", "gearbox_result").root;
  result["problem"]["cutter"] = {{"hob_tip_radius", .25}, {"shaper_teeth", 30}};
  const fs::path file = folder.write("result.json", result.dump());
  json root = io::read_document(kSpecs / "d151_strength.json", "gear_strength").root;
  root["gearbox"]["file"] = file.string();
  const auto read = [&] {
    return strength_of(io::check_document(root, "gear_strength", file.string(), ""));
  };
  ReadStrength strength = read();
  EXPECT_EQ(strength.strength.train.cutters.hob_tip_radius, .25);
  EXPECT_EQ(strength.strength.train.cutters.shaper_teeth, 30);
  EXPECT_TRUE(strength.statements.empty());
  root["cutter"] = {{"hob_tip_radius", .2}, {"shaper_tip_radius", .1}};
  strength = read();
  EXPECT_EQ(strength.strength.train.cutters.hob_tip_radius, .2);
  EXPECT_EQ(strength.strength.train.cutters.shaper_tip_radius, .1);
  EXPECT_EQ(strength.strength.train.cutters.shaper_teeth, 30);
  EXPECT_EQ(strength.statements,
            std::vector<std::string>{"The cutter differs from that of the result's problem: "
                                     "hob_tip_radius is 0.2 here and 0.25 there."});
}

TEST(ReadStrength, RefusesA3kTrainThatStandsStill) {
  const json teeth = {
      {"sun", 20}, {"planet_1", 30}, {"planet_2", 30}, {"fixed_ring", 80}, {"output_ring", 80}};
  json root = ankle_document();
  root["gearbox"] = {{"topology", "3k"}, {"teeth", teeth}, {"planet_count", 3}, {"module_mm", .6}};
  root["face_width_mm"]["layer_2"] = 5;
  EXPECT_THROW(strength_of(io::check_document(root, "gear_strength", "f", "")), io::SpecError);
}

/// Oracle: all stages by brute force, exact in tenths of the ratio 8.
std::int64_t most_sun_teeth(std::int64_t ring_limit, std::int64_t planets) {
  std::int64_t best = 0;
  for (std::int64_t ring = 1; ring <= ring_limit; ++ring) {
    for (std::int64_t sun = 1; sun < ring; ++sun) {
      if (ring != 7 * sun || (ring - sun) % 2 != 0 || (ring + sun) % planets != 0) continue;
      const std::int64_t planet = (ring - sun) / 2;
      const double chord = static_cast<double>(sun + planet) *
                           std::sin(std::numbers::pi / static_cast<double>(planets));
      if (chord > static_cast<double>(planet + 2) && sun >= 15) best = std::max(best, sun);
    }
  }
  return best;
}

TEST(StageWithMostTeeth, IsThatOfTheEnumeration) {
  const GearTrain stage = read_strength(kSpecs / "d110a_strength.json").strength.train;
  for (const double module_mm : {.3, .5, .6, .7, .8}) {
    const auto teeth = stage_with_most_teeth(stage, module_mm, 90);
    ASSERT_EQ(teeth.size(), 3u) << module_mm;
    const auto limit = static_cast<std::int64_t>(std::floor(90 / module_mm - 7.0 + 1e-9));
    EXPECT_EQ(teeth[0], most_sun_teeth(limit, 3)) << module_mm;
    EXPECT_EQ(teeth[2], 7 * teeth[0]);
  }
  EXPECT_TRUE(stage_with_most_teeth(stage, 1.0, 90).empty());  // 12 teeth: undercut
  GearTrain crowded = stage;
  crowded.planet_count = 4;  // 2 a sin(45) = 2.83 S is less than the planets' 3 S
  EXPECT_TRUE(stage_with_most_teeth(crowded, .5, 90).empty());
}

TEST(StrengthVariants, AreModulesTimesWidths) {
  const ReadStrength read = read_strength(kSpecs / "d110a_strength.json");
  const StrengthVariants variants =
      strength_variants(read.strength, {.5, .6, 1.0}, {6, 8, 10}, *read.ring_space_mm);
  ASSERT_EQ(variants.cases.size(), 6u);
  EXPECT_EQ(variants.left_out.size(), 1u);
  EXPECT_EQ(variants.cases[4].train.face_width_mm.front(), 8);
  EXPECT_EQ(variants.cases[4].train.module_mm, .6);
  EXPECT_EQ(variants.cases[4].train.teeth, (std::vector<std::int64_t>{18, 54, 126}));
}

}  // namespace
}  // namespace torquewright::gearbox
