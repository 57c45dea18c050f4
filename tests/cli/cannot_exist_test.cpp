// SPDX-License-Identifier: Apache-2.0
// What no gearbox can miss, where the paper's constraints let it pass: said once, and drawn.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++times;
  }
  return times;
}

// Oracle: nine planets of 44 + 2 teeth on a circle of 42 modules, 2 * 42 sin(20 deg) = 28.7 < 46.
TEST(CannotExist, IsNotedOnceAndWrittenOnTheDrawing) {
  Workplace place;
  place.write("knee.json", knee());
  const Outcome outcome = place.run({"gearbox", "evaluate", "knee.json", "--teeth", "40,44,30",
                                     "--planet-count", "9", "--draw", "knee.svg"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(count(outcome.out, " neighbour_clearance.layer_1: "), 1U) << outcome.out;
  EXPECT_EQ(count(outcome.out, "cannot_exist: neighbour_clearance.layer_1: "), 1U);
  // A condition that a gearbox can miss is noted as before.
  EXPECT_EQ(count(outcome.out, "not asked for: identical_planets: "), 1U);
  EXPECT_EQ(
      count(place.text("knee.svg"), "cannot exist: equal_spacing, neighbour_clearance.layer_1, "),
      1U);
}

TEST(CannotExist, IsNotSaidOfAGearboxThatDoes) {
  Workplace place;
  place.write("knee.json", knee());
  const Outcome outcome =
      place.run({"gearbox", "evaluate", "knee.json", "--teeth", "44,44,32", "--draw", "knee.svg"});
  EXPECT_EQ(count(outcome.out, "cannot_exist"), 0U);
  EXPECT_EQ(count(place.text("knee.svg"), "cannot exist"), 0U);
}

// Oracle: of 3K gears the ratio is that of S (P1 - P2): planets alike let the output stand still,
// and no ratio is what reflects an inertia.
TEST(CannotExist, IsARatioWherePlanetsAreAlike) {
  Workplace place;
  place.write("knee.json", knee());
  const Outcome outcome = place.run({"gearbox", "evaluate", "knee.json", "--teeth", "44,44,44"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(count(outcome.out, "  ratio             does not exist, the output stands still"), 1U)
      << outcome.out;
  EXPECT_EQ(count(outcome.out, "not known, the output stands still"), 1U) << outcome.out;
  const auto result = nlohmann::json::parse(
      place.run({"gearbox", "evaluate", "knee.json", "--teeth", "44,44,44", "--json"}).out);
  for (const char* key : {"ratio", "forward_efficiency", "backward_efficiency", "self_locking"}) {
    EXPECT_TRUE(result["designs"][0][key].is_null()) << key;
  }
}

}  // namespace
}  // namespace torquewright::cli_test
