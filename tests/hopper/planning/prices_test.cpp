// SPDX-License-Identifier: Apache-2.0
// What more of a margin or a phase costs. Oracle: two programs solved anew, with a little less and
// a little more of it.
#include "hopper/planning/search/prices.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "hopper/planning/programme/guess.hpp"
#include "hopper/planning/programme/plan_setup.hpp"
#include "hopper/planning/tasks/reserve.hpp"
#include "io/faults/spec_error.hpp"
#include "tests/hopper/planning/sagittal_states.hpp"

namespace torquewright::hopper {
namespace {

/// A jump of one leg on a coarse mesh, and its program's optimum.
struct Jump {
  Robot robot = test::documented_robot("planar_leg");
  PlanOptions options;
  PlanModel model;  // which the program's rows look at
  PlanGoal goal;
  SolvedProgram solved;

  static PlanOptions usual() {
    PlanOptions options;
    options.task = &tasks::jump;
    options.rise_m = 0.25;
    options.intervals = 20;
    options.reserve = 0.02;
    options.margins = with_reserve(options.reserve);
    return options;
  }
  explicit Jump(const PlanOptions& of = usual(), const PlannedMotion* guess = nullptr)
      : options(of), model(plan_model(robot, options)), goal(plan_goal(model, options)) {
    const auto mesh = first_mesh(plan_stances(model.plane, options), options);
    solved.guess = guess != nullptr ? *guess : key_frame_guess(model, mesh, goal, options);
    solved.program = flip_program(model, mesh, goal, options, solved.guess);
    optimization::NonlinearOptions solver;
    solver.tolerance = 1e-8;
    solved.solution = optimization::solve(solved.program.program, solver);
  }
  double objective() const {
    EXPECT_TRUE(solved.solution.is_solved());
    return solved.solution.objective;
  }
};

/// By central differences of what `add` adds to.
double slope(const Jump& of, const std::function<void(PlanOptions&, double)>& add) {
  constexpr double kStep = 2e-4;
  PlanOptions less = of.options, more = of.options;
  add(less, -kStep);
  add(more, kStep);
  return (Jump(more, &of.solved.guess).objective() - Jump(less, &of.solved.guess).objective()) /
         (2.0 * kStep);
}

const BoundPrice& named(const std::vector<BoundPrice>& prices, const std::string& name) {
  return *std::find_if(prices.begin(), prices.end(),
                       [&](const BoundPrice& one) { return one.name == name; });
}

// The objective is known to 1e-8 of its scale: the step leaves four digits, curvature a few less.
TEST(BoundPrices, AreTheSlopesOfTheObjective) {
  const Jump jump;
  ASSERT_TRUE(jump.solved.solution.is_solved());
  const std::vector<BoundPrice> prices =
      bound_prices(jump.robot, jump.options, jump.solved, KeptMargins());
  ASSERT_EQ(prices.size(), margin_parts().size() - 1 + 5);  // flat ground has no edges
  const auto expect = [&](const std::string& name, auto add) {
    SCOPED_TRACE(name);
    const BoundPrice& price = named(prices, name);
    ASSERT_TRUE(price.objective_per_unit);
    const double expected = slope(jump, add);
    EXPECT_NE(expected, 0.0);
    EXPECT_NEAR(*price.objective_per_unit, expected, 0.02 * std::abs(expected) + 1e-4);
  };
  expect("voltage", [](PlanOptions& of, double more) { of.margins.voltage += more; });
  expect("current", [](PlanOptions& of, double more) { of.margins.current += more; });
  expect("longest first phase", [](PlanOptions& of, double more) { of.longest.first_s += more; });
}

TEST(Reserve, IsSoManyTimesEachPart) {
  const PlanMargins margins = with_reserve(0.08);
  EXPECT_DOUBLE_EQ(margins.voltage, 0.08);
  EXPECT_DOUBLE_EQ(margins.friction, 0.15);
  EXPECT_DOUBLE_EQ(margins.center_of_pressure, 0.3);
  EXPECT_DOUBLE_EQ(margins.capture_point, 0.3);
  EXPECT_DOUBLE_EQ(margins.position_rad, 0.15);
  EXPECT_DOUBLE_EQ(margins.flight_position_rad, 0.15);
  EXPECT_DOUBLE_EQ(margins.edge_m, 0.02);
  EXPECT_DOUBLE_EQ(margins.gear_load, PlanMargins().gear_load);
  // The usual ones are the least.
  EXPECT_DOUBLE_EQ(with_reserve(0.001).friction, PlanMargins().friction);
  EXPECT_DOUBLE_EQ(with_reserve(0.0).voltage, PlanMargins().voltage);
}

TEST(Reserve, BeyondWhatThereIsNamesThePartAndHowMuchThereIs) {
  try {
    with_reserve(0.2);
    FAIL() << "0.75 of the foot from either end";
  } catch (const io::SpecError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("--center-of-pressure-margin"), std::string::npos) << said;
    EXPECT_NE(said.find("0.49"), std::string::npos) << said;
  }
}

// Of both prices by what the reserve makes of the parts: 2 * 1 + 3 * 4.
// Whatever was asked for, the reserve that the refusal offers is one, and but for its rounding the
// greatest.
TEST(Reserve, OffersOneThatLeavesSomethingOfEveryPart) {
  for (const double asked : {0.14, 0.3, 0.9}) {
    try {
      (void)with_reserve(asked);
      ADD_FAILURE() << asked;
    } catch (const io::SpecError& error) {
      const std::string words = error.what();
      const std::string option = "with: --reserve ";
      const std::size_t at = words.find(option);
      ASSERT_NE(at, std::string::npos) << words;
      const double offered = std::stod(words.substr(at + option.size()));
      EXPECT_NO_THROW((void)with_reserve(offered)) << words;
      EXPECT_THROW((void)with_reserve(offered + 1e-3), io::SpecError) << words;
    }
  }
}

TEST(Reserve, CostsWhatItsPartsCost) {
  EXPECT_EQ(
      reserve_price({{"a", 0.1, "", 1.0, 2.0}, {"b", 0.4, "", 4.0, 3.0}, {"c", 0.1, "", 0.0, {}}}),
      14.0);
  EXPECT_EQ(reserve_price({{"a", 0.1, "", 0.0, 2.0}}), std::nullopt);
  EXPECT_EQ(reserve_price({{"a", 0.1, "", 1.0, {}}}), std::nullopt);
}

}  // namespace
}  // namespace torquewright::hopper
