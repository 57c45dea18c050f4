// SPDX-License-Identifier: Apache-2.0
// The rotor's bore bounds a pitch circle; the report's first line says where the blank stands.
#include <gtest/gtest.h>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

std::string first_row(const std::string& teeth) {
  const std::string knee = in_repository("specs/gearbox/d151_knee.json").string();
  const std::string text = run({"gearbox", "evaluate", knee, "--teeth", teeth}).out;
  const std::size_t start = text.find("  ring blank");
  if (start == std::string::npos || start > text.find("  objective")) return text;
  return text.substr(start, text.find('\n', start) - start);
}

// Oracle: m (z + 2.5) + 2 (2.25 m) with m = 0.6 mm: 83.4 mm of 132 teeth, 76.2 mm of 120.
TEST(RingBlank, IsHeldAgainstTheRotorsBoreInTheFirstLine) {
  EXPECT_EQ(first_row("44,44,32"),
            "  ring blank        83.4 mm, does not fit into the rotor's bore of 79.4 mm");
  EXPECT_EQ(first_row("24,48,28"),
            "  ring blank        76.2 mm, fits into the rotor's bore of 79.4 mm");
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++found;
  }
  return found;
}

// Eleven planets of 46 modules over the tips where (44 + 44) sin(pi/11) = 24.8 modules are between
// their axes: the paper's constraints let it pass.
TEST(CannotExist, IsSaidOnceAndDrawn) {
  const Workplace place;
  place.write("knee.json", knee());
  const Outcome outcome = place.run({"gearbox", "evaluate", "knee.json", "--teeth", "44,44,32",
                                     "--planet-count", "11", "--draw", "x.svg"});
  EXPECT_EQ(count(outcome.out, "neighbour_clearance.layer_1: "), 1u) << outcome.out;
  EXPECT_EQ(count(outcome.out, "cannot_exist: neighbour_clearance.layer_1: "), 1u);
  EXPECT_NE(place.text("x.svg").find("cannot exist: neighbour_clearance.layer_1"),
            std::string::npos);
}

}  // namespace
}  // namespace torquewright::cli_test
