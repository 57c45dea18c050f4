// SPDX-License-Identifier: Apache-2.0
// Oracle: the profile itself, written and read again; heights by the definition of its edges.
#include "hopper/motion/ground_line.hpp"

#include <gtest/gtest.h>

#include "io/faults/spec_error.hpp"

namespace torquewright::hopper {
namespace {

using simulation::GroundProfile;

TEST(GroundLine, IsReadAsItWasWritten) {
  const GroundProfile profiles[] = {
      {}, {{0.17}, {0.0, 0.085}}, {{-1.0 / 3.0, 0.25, 1e2}, {0.1, -0.2, 0.0, 1.0 / 7.0}}};
  for (const GroundProfile& ground : profiles) {
    std::string line = ground_line(ground);
    if (!line.empty()) line.pop_back();
    const GroundProfile again = read_ground({"# made by hand", line, "#"}, "a.csv");
    EXPECT_EQ(again.edges_x_m, ground.edges_x_m) << line;
    EXPECT_EQ(again.heights_m, ground.heights_m) << line;
  }
  EXPECT_EQ(ground_line({{0.17}, {0.0, 0.085}}),
            "# ground profile: z = 0 m up to x = 0.17 m, then z = 0.085 m\n");
}

TEST(GroundLine, AnEdgeHasTheHeightOfItsRight) {
  const GroundProfile ground{{-1.0, 2.0}, {3.0, 0.0, 5.0}};
  const double places[][2] = {{-1e9, 3.0}, {-1.0001, 3.0}, {-1.0, 0.0}, {1.999, 0.0}, {2.0, 5.0}};
  for (const auto& [x_m, height_m] : places) EXPECT_EQ(ground.height_m(x_m), height_m) << x_m;
  EXPECT_EQ(GroundProfile().height_m(7.0), 0.0);
}

TEST(GroundLine, WhatIsNoGroundIsRefused) {
  const std::string good = "# ground profile: z = 0 m up to x = 1 m, then z = 1 m";
  const std::vector<std::vector<std::string>> bad = {
      {"# ground profile: concrete"},
      {"# ground profile: z = 0 m"},
      {"# ground profile: z = 0 m up to x = nan m, then z = 1 m"},
      {"# ground profile: z = 0 m up to x = 1 m, then z = 2000 m"},
      {"# ground profile: z = 0 m up to x = 1 m, then z = 1 m up to x = 1 m, then z = 2 m"},
      {good + ", or so"},
      {good, good}};
  for (const auto& lines : bad)
    EXPECT_THROW(read_ground(lines, "a.csv"), io::SpecError) << lines[0];
  EXPECT_NO_THROW(read_ground({good, "# ground profiles are nice"}, "a.csv"));
}

}  // namespace
}  // namespace torquewright::hopper
