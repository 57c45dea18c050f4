// SPDX-License-Identifier: Apache-2.0
// Which single changes are tried where there is no plan. Oracle: the documents' own values.
#include "hopper/planning/search/explanation.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "hopper/planning/tasks/reserve.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {
namespace {

Robot documented() {
  return read_robot(std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "specs/robot/hopper.json")
      .robot;
}

std::vector<std::string> names_of(const std::vector<ChangeTried>& changes) {
  std::vector<std::string> names;
  for (const ChangeTried& change : changes) names.push_back(change.quantity);
  return names;
}

// Both ankle drives at once: one alone would lead out of the plane.
TEST(Explanation, NamesEveryQuantityThoughThereIsNoTime) {
  const std::vector<ChangeTried> changes = changes_that_help(documented(), {}, 0.0);
  EXPECT_EQ(names_of(changes),
            (std::vector<std::string>{"voltage", "current", "knee_ratio", "knee_ratio",
                                      "ankle_ratio", "ankle_ratio", "mass"}));
  for (const ChangeTried& change : changes) {
    EXPECT_TRUE(change.is_cut_off);
    EXPECT_FALSE(change.has_plan);
    EXPECT_EQ(change.to, change.from) << "nothing was tried";
  }
  EXPECT_NEAR(changes[0].from, 16 * 4.2, 1e-9);  // 16 cells
  EXPECT_EQ(changes[2].from, 20.0);
  EXPECT_EQ(changes[4].from, 8.0);
}

TEST(Explanation, ChangesTheVoltageThatWasAskedFor) {
  PlanOptions options;
  options.check.conditions.bus_voltage_V = 50.0;
  options.should_stop = [] { return true; };
  const std::vector<ChangeTried> changes = changes_that_help(documented(), options, 1e3);
  ASSERT_FALSE(changes.empty());
  EXPECT_EQ(changes[0].quantity, "voltage");
  EXPECT_EQ(changes[0].from, 50.0);
  EXPECT_EQ(changes[0].unit, "V");
  EXPECT_TRUE(changes[0].is_cut_off);
}

// Three iterations find nothing, whatever is changed: the ladder is climbed to its end, 40 %.
TEST(Explanation, SaysHowFarItTriedWhereNothingHelps) {
  PlanOptions options;
  options.task = &tasks::jump;
  options.intervals = 20;
  options.most_iterations = 3;
  const std::vector<ChangeTried> changes = changes_that_help(documented(), options, 1e3);
  const double signs[]{1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0};
  ASSERT_EQ(changes.size(), std::size(signs));
  for (std::size_t i = 0; i < changes.size(); ++i) {
    EXPECT_FALSE(changes[i].has_plan) << changes[i].quantity;
    EXPECT_FALSE(changes[i].is_cut_off) << changes[i].quantity;
    EXPECT_NEAR(changes[i].to / changes[i].from, 1.0 + 0.4 * signs[i], 1e-12)
        << changes[i].quantity;
  }
}

// Oracle: the multiples of reserve.cpp's table and the usual margins, by hand. What is stated by
// itself is not the reserve's.
TEST(Explanation, GivesUpPartsOfTheReserveDownToTheUsual) {
  PlanOptions options;
  options.task = &tasks::jump;
  options.intervals = 20;
  options.most_iterations = 3;
  options.reserve = 0.08;
  options.margins = with_reserve(options.reserve);
  options.margins.capture_point = 0.2;
  const std::vector<ChangeTried> changes = changes_that_help(documented(), options, 1e3);
  const ChangeTried expected[]{{"reserve of voltage", 0.08, 0.01, ""},
                               {"reserve of centre of pressure", 0.3, 0.1, ""},
                               {"reserve of joint range", 0.15, 0.02, "rad"},
                               {"reserve of joint range in flight", 0.15, 0.0, "rad"}};
  ASSERT_GT(changes.size(), std::size(expected));
  for (std::size_t i = 0; i < std::size(expected); ++i) {
    EXPECT_EQ(changes[i].quantity, expected[i].quantity);
    EXPECT_NEAR(changes[i].from, expected[i].from, 1e-12) << changes[i].quantity;
    EXPECT_NEAR(changes[i].to, expected[i].to, 1e-12) << changes[i].quantity;
    EXPECT_EQ(changes[i].unit, expected[i].unit);
    EXPECT_FALSE(changes[i].has_plan);
  }
  EXPECT_EQ(changes[std::size(expected)].unit, "V") << "then the robot's";
}

TEST(Explanation, IsOfWhatTheSolverEndedWithItself) {
  EXPECT_TRUE(can_be_explained(PlanStatus::kLocallyInfeasible));
  EXPECT_TRUE(can_be_explained(PlanStatus::kCheckFails));
  EXPECT_FALSE(can_be_explained(PlanStatus::kPlanned));
  EXPECT_FALSE(can_be_explained(PlanStatus::kLimit));
}

}  // namespace
}  // namespace torquewright::hopper
