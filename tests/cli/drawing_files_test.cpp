// SPDX-License-Identifier: Apache-2.0
// `gearbox drawing --step` as a user runs it: what it writes, what it assumes and what it refuses.
// What the solids are like: tests/report/step.
#include <gtest/gtest.h>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

Outcome drawing(const Workplace& place, std::vector<std::string> options) {
  options.insert(options.begin(),
                 {"gearbox", "drawing", in_specs("gearbox/d151_knee_result.json")});
  return place.run(options);
}

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++count;
  }
  return count;
}

TEST(StepFiles, HoldTheAssembledTrain) {
  const Workplace place;
  const Outcome outcome = drawing(place, {"--step", "gears.step", "--face-width", "10,9"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("face width                   9.0000 mm"), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("Solids: the sun has a bore of 22.2 mm, planets have none (--bore); "
                             "layer 2 begins at 10 mm.\n"),
            std::string::npos)
      << outcome.out;
  const std::string text = place.text("gears.step");
  EXPECT_TRUE(text.starts_with("ISO-10303-21;\n"));
  EXPECT_TRUE(text.ends_with("END-ISO-10303-21;\n"));
  EXPECT_EQ(count_of(text, "=MANIFOLD_SOLID_BREP("), 5U);
  EXPECT_EQ(count_of(text, "=NEXT_ASSEMBLY_USAGE_OCCURRENCE("), 11U);
  EXPECT_NE(text.find("'planet_2 4 of 4'"), std::string::npos);
}

TEST(StepFiles, AreTheSameBytesEachTime) {
  const Workplace place;
  drawing(place, {"--step", "first.step", "--face-width", "10"});
  drawing(place, {"--step", "second.step", "--face-width", "10,10"});
  EXPECT_EQ(place.text("first.step"), place.text("second.step"));
}

TEST(StepFiles, HaveTheBoresThatAreStated) {
  const Workplace place;
  const auto cylinders = [&](const std::vector<std::string>& bores) {
    std::vector<std::string> options{"--step", "gears.step", "--face-width", "10"};
    options.insert(options.end(), bores.begin(), bores.end());
    EXPECT_EQ(drawing(place, options).exit_code, 0);
    return count_of(place.text("gears.step"), "=FACE_BOUND(");  // Two of every hole.
  };
  EXPECT_EQ(cylinders({}), 6U);
  EXPECT_EQ(cylinders({"--bore", "planet_1=6,planet_2=6"}), 10U);
  EXPECT_EQ(cylinders({"--bore", "sun=0"}), 4U);
}

// What is stated of widths is drawn too; a bore is of solids alone.
TEST(StepFiles, ShareTheirWidthsWithTheSheet) {
  const Workplace place;
  EXPECT_EQ(drawing(place, {"--svg", "sheet.svg", "--face-width", "10.5,9.25"}).exit_code, 0);
  const std::string sheet = place.text("sheet.svg");
  for (const char* width : {"b1 = 10.5", "b2 = 9.25"}) {
    EXPECT_NE(sheet.find(width), std::string::npos) << width;
  }
  const Outcome bored = drawing(place, {"--svg", "other.svg", "--bore", "sun=5"});
  EXPECT_EQ(bored.exit_code, 2);
  EXPECT_NE(bored.err.find("--step"), std::string::npos) << bored.err;
  EXPECT_FALSE(place.has("other.svg"));
}

TEST(StepFiles, RefuseWhatIsNoBody) {
  const Workplace place;
  const auto refusal = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--step", "gears.step"});
    const Outcome outcome = drawing(place, options);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(place.has("gears.step"));
    return outcome.err;
  };
  EXPECT_NE(refusal({}).find("d151_knee_result.json#/problem/face_width_mm: missing, and solids "
                             "need it; say --face-width MM (by layer: 10,8)\n"),
            std::string::npos);
  EXPECT_EQ(refusal({"--face-width", "10,9,8"}),
            "--face-width: has 3 numbers; this train has 2 layers\n");
  EXPECT_EQ(
      refusal({"--face-width", "10", "--bore", "fixed_ring=5"}),
      "--bore: \"fixed_ring=5\" names no gear with a bore; 3k has sun, planet_1, planet_2, as "
      "in planet_1=5\n");
  for (const char* bore : {"sun=", "sun=nan", "sun=-1", "sun=1e9", "sun=5mm", "sun=0x5"}) {
    EXPECT_NE(refusal({"--face-width", "10", "--bore", bore}).find("needs a diameter from 0 to"),
              std::string::npos)
        << bore;
  }
  EXPECT_NE(refusal({"--face-width", "10", "--bore", "sun=25"})
                .find("no solids for --step: sun: a bore of 25 mm leaves no rim in a root of 24.9 "
                      "mm\n"),
            std::string::npos);
}

}  // namespace
}  // namespace torquewright::cli_test
