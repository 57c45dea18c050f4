// SPDX-License-Identifier: Apache-2.0
// Oracle: grids by hand.
#include "src/sweep/grid.hpp"

#include <gtest/gtest.h>

#include <set>

#include "io/faults/spec_error.hpp"

namespace torquewright::sweep {
namespace {

using Values = std::vector<double>;

TEST(Axis, IsARangeThatItsStepsMeet) {
  const Axis axis = read_axis("knee_ratio=8:30:2");
  EXPECT_EQ(axis.name, "knee_ratio");
  EXPECT_EQ(axis.values, (Values{8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30}));
  EXPECT_EQ(read_axis("a=8:31:2").values.back(), 30);
  EXPECT_EQ(read_axis("a=5:5:1").values, Values{5});
  EXPECT_EQ(read_axis("a=-1:1:1").values, (Values{-1, 0, 1}));
  EXPECT_EQ(read_axis("a=12:14.5").values, (Values{12, 13, 14}));
}

// 0.1 + 0.1 + 0.1 is not 0.3 in binary; these are the numbers that the decimals stand for.
TEST(Axis, HasNoRoundingSummedUp) {
  EXPECT_EQ(read_axis("a=0.1:0.7:0.1").values, (Values{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7}));
}

TEST(Axis, IsAListInOrder) {
  EXPECT_EQ(read_axis("voltage=67.2,48,52.8").values, (Values{48, 52.8, 67.2}));
  EXPECT_EQ(read_axis("voltage=48").values, Values{48});
}

TEST(Axis, IsRefused) {
  for (const char* text :
       {"knee_ratio", "=1:2:1",  "a=",        "a=1:",   "a=1:2:3:4", "a=1:2:0",    "a=1:2:-1",
        "a=3:2:1",    "a=x:2:1", "a=1,,2",    "a=1,2,", "a=1,1",     "a=1,1.0",    "a=nan",
        "a=1:inf:1",  "a=1 ,2",  "a=0:1e9:1", "a=0x10", "a=1e400",   "a=1:2:1e400"}) {
    EXPECT_THROW(read_axis(text), io::SpecError) << text;
  }
}

TEST(Grid, NumbersPointsWithTheLastAxisFirst) {
  const Grid grid = read_grid({"a=1,2", "b=10:30:10"});
  ASSERT_EQ(grid.points(), 6u);
  EXPECT_EQ(grid.values_at(0), (Values{1, 10}));
  EXPECT_EQ(grid.values_at(1), (Values{1, 20}));
  EXPECT_EQ(grid.values_at(3), (Values{2, 10}));
  EXPECT_EQ(grid.values_at(5), (Values{2, 30}));
  EXPECT_EQ(grid.name_of(5), "a=2 b=30");
}

TEST(Grid, NamesEveryPointDifferently) {
  const Grid grid = read_grid({"a=1,1.0000000000000002", "b=0.1:0.9:0.1"});
  std::set<std::string> names;
  for (std::size_t i = 0; i < grid.points(); ++i) names.insert(grid.name_of(i));
  EXPECT_EQ(names.size(), grid.points());
}

TEST(Grid, IsRefused) {
  EXPECT_THROW(read_grid({}), io::SpecError);
  EXPECT_THROW(read_grid({"a=1", "b=1", "c=1"}), io::SpecError);
  EXPECT_THROW(read_grid({"a=1", "a=2"}), io::SpecError);
  EXPECT_THROW(read_grid({"a=1:1000:1", "b=1:1000:1"}), io::SpecError);
}

}  // namespace
}  // namespace torquewright::sweep
