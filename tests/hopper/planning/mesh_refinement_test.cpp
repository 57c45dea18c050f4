// SPDX-License-Identifier: Apache-2.0
// Oracle: the rule, by hand.
#include "hopper/planning/programme/mesh_refinement.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace torquewright::hopper {
namespace {

using Knots = std::vector<double>;

TEST(MeshRefinement, HalvesIntervalsWithMoreThanTheirPart) {
  // Of 0.4 each of four may have 0.1.
  EXPECT_EQ(refined({0.0, 0.25, 0.5, 0.75, 1.0}, {0.2, 0.05, 0.11, 0.0}, 0.4),
            (Knots{0.0, 0.125, 0.25, 0.5, 0.625, 0.75, 1.0}));
}

TEST(MeshRefinement, LeavesAMeshThatIsGoodEnough) {
  const Knots knots{0.0, 0.1, 0.4, 1.0};
  EXPECT_EQ(refined(knots, {0.1, 0.1, 0.1}, 0.3 + 1e-12), knots);
}

TEST(MeshRefinement, HalvesWhatCouldNotBeIntegrated) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refined({0.0, 0.5, 1.0}, {0.0, kNone}, 1.0), (Knots{0.0, 0.5, 0.75, 1.0}));
}

TEST(MeshRefinement, OfHalvesAllAtMost) {
  EXPECT_EQ(refined({0.0, 1.0}, {1.0}, 0.5), (Knots{0.0, 0.5, 1.0}));
  EXPECT_EQ(refined({0.0, 0.2, 1.0}, {9.0, 9.0}, 0.5), (Knots{0.0, 0.1, 0.2, 0.6, 1.0}));
}

}  // namespace
}  // namespace torquewright::hopper
