// SPDX-License-Identifier: Apache-2.0
// Each way in which a search ends. Oracle: problems whose outcome is plain by hand.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <thread>
#include <type_traits>

#include "optimization/nonlinear/solve.hpp"
#include "tests/optimization/nonlinear/formula_rows.hpp"

namespace torquewright::optimization {
namespace {

constexpr auto kRosenbrock2 = [](const auto& x) {
  const auto valley = x[1] - x[0] * x[0];
  return 100.0 * valley * valley + (1.0 - x[0]) * (1.0 - x[0]);
};

/// Takes some twenty steps.
Program valley() {
  Program program;
  program.add({"x", {-2.0, 1.0}, {{}, {}}, {1.0, 1.0}});
  program.add_cost(formula_cost({0, 1}, kRosenbrock2));
  return program;
}
constexpr double kValleyStart = 909.0;  // 100 (1 - 4)^2 + 3^2

/// min (x - 3)^2 + (y - 2)^2 with x + y <= 1: the foot of the perpendicular, (1, 0); the gradient
/// (-4, -4) is balanced by 4 times the row's.
Program perpendicular() {
  Program program;
  program.add({"x", {0.0, 0.0}, {{}, {}}, {1.0, 1.0}});
  program.add_cost(formula_cost({0, 1}, [](const auto& x) {
    return (x[0] - 3.0) * (x[0] - 3.0) + (x[1] - 2.0) * (x[1] - 2.0);
  }));
  program.add_rows(formula_rows(
      {0, 1}, {{-HUGE_VAL, 1.0}},
      []<typename N>(const std::vector<N>& x) { return std::vector<N>{x[0] + x[1]}; }));
  return program;
}

template <typename Formula>
Program of_one_unknown(double start, Formula cost) {
  Program program;
  program.add({"x", {start}, {{}}, {1.0}});
  program.add_cost(formula_cost({0}, cost));
  return program;
}

/// A row of one unknown whose value and slope are given, whatever the slope has to do with it.
class OddRow final : public Rows {
 public:
  using Function = double (*)(double);
  OddRow(const Bounds& bounds, Function value, Function slope)
      : Rows("odd", {0}, {bounds}, {1.0}), value_(value), slope_(slope) {}
  void values(const VectorIn& x, VectorOut rows) const override { rows(0) = value_(x(0)); }
  void slopes(const VectorIn& x, MatrixOut jacobian) const override {
    jacobian(0, 0) = slope_(x(0));
  }
  void curvatures(const VectorIn&, const VectorIn& multipliers, MatrixOut hessian) const override {
    hessian(0, 0) = 2.0 * multipliers(0);
  }

 private:
  Function value_, slope_;
};

Program with_odd_cost(OddRow::Function value, OddRow::Function slope) {
  Program program;
  program.add({"x", {1.0}, {{}}, {1.0}});
  program.add_cost(std::make_unique<OddRow>(Bounds(), value, slope));
  return program;
}

TEST(NonlinearStatus, SolvedAtTheFootOfAPerpendicular) {
  const NonlinearSolution solution = solve(perpendicular(), {});
  EXPECT_EQ(solution.status, NonlinearStatus::kSolved);
  EXPECT_TRUE(solution.is_solved());
  EXPECT_NEAR(solution.values.at(0), 1.0, 1e-6);
  EXPECT_NEAR(solution.values.at(1), 0.0, 1e-6);
  EXPECT_NEAR(solution.multipliers.at(0), 4.0, 1e-6);
}

// x^2, whose slopes are off by 1e-6 to either side as rounding might have it: they never fall below
// the tolerance of 1e-7, and stay below a hundred times it.
TEST(NonlinearStatus, AcceptableWhereSlopesAreRough) {
  const Program program = with_odd_cost(
      [](double x) { return x * x; }, [](double x) { return 2.0 * x + (x < 0.0 ? -1e-6 : 1e-6); });
  const NonlinearSolution solution = solve(program, {});
  EXPECT_EQ(solution.status, NonlinearStatus::kAcceptable);
  EXPECT_TRUE(solution.is_solved());
  EXPECT_NEAR(solution.values.at(0), 0.0, 1e-5);
}

// x^2 <= -1 is violated least at 0, by 1.
TEST(NonlinearStatus, LocallyInfeasibleWhereViolationIsLeast) {
  Program program = of_one_unknown(3.0, [](const auto& x) { return x[0]; });
  program.add_rows(formula_rows({0}, {{-HUGE_VAL, -1.0}}, []<typename N>(const std::vector<N>& x) {
    return std::vector<N>{x[0] * x[0]};
  }));
  const NonlinearSolution solution = solve(program, {});
  EXPECT_EQ(solution.status, NonlinearStatus::kLocallyInfeasible);
  EXPECT_FALSE(solution.is_solved());
  EXPECT_NEAR(solution.values.at(0), 0.0, 1e-3);
  EXPECT_NEAR(solution.largest_violation, 1.0, 1e-6);
}

TEST(NonlinearStatus, LocallyInfeasibleWhereNothingIsFree) {
  Program program;
  program.add({"x", {0.0}, {{2.0, 2.0}}, {1.0}});
  program.add_rows(
      formula_rows({0}, {{0.0, 1.0}}, []<typename N>(const std::vector<N>& x) { return x; }));
  const NonlinearSolution solution = solve(program, {});
  EXPECT_EQ(solution.status, NonlinearStatus::kLocallyInfeasible);
  EXPECT_EQ(solution.values, std::vector<double>{2.0});
  EXPECT_EQ(solution.largest_violation, 1.0);
}

TEST(NonlinearStatus, IterationLimit) {
  const NonlinearSolution solution = solve(valley(), {.most_iterations = 3});
  EXPECT_EQ(solution.status, NonlinearStatus::kIterationLimit);
  EXPECT_EQ(solution.iterations, 3);
  EXPECT_LT(solution.objective, kValleyStart);
}

TEST(NonlinearStatus, TimeLimitBeforeTheFirstStep) {
  const NonlinearSolution solution = solve(valley(), {.most_seconds = 0.0});
  EXPECT_EQ(solution.status, NonlinearStatus::kTimeLimit);
  EXPECT_EQ(solution.values, (std::vector<double>{-2.0, 1.0}));
  EXPECT_EQ(solution.objective, kValleyStart);
}

// Twenty steps of 20 ms at least do not fit in 50 ms of wall clock, of which the processor works
// next to nothing.
TEST(NonlinearStatus, TimeLimitOnTheWallClock) {
  const auto wait = [](const NonlinearIterate&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  };
  const NonlinearSolution solution = solve(valley(), {.most_seconds = 0.05, .on_iterate = wait});
  EXPECT_EQ(solution.status, NonlinearStatus::kTimeLimit);
  EXPECT_LE(solution.objective, kValleyStart);
}

TEST(NonlinearStatus, InterruptedWhenAsked) {
  int questions = 0;
  const NonlinearSolution solution =
      solve(valley(), {.should_stop = [&] { return ++questions > 5; }});
  EXPECT_EQ(solution.status, NonlinearStatus::kInterrupted);
  EXPECT_EQ(questions, 6);
  EXPECT_LT(solution.objective, kValleyStart);
}

TEST(NonlinearStatus, InterruptedBeforeTheFirstStep) {
  const NonlinearSolution solution = solve(valley(), {.should_stop = [] { return true; }});
  EXPECT_EQ(solution.status, NonlinearStatus::kInterrupted);
  EXPECT_EQ(solution.iterations, 0);
  EXPECT_EQ(solution.objective, kValleyStart);
}

// -x has no least value.
TEST(NonlinearStatus, DivergedWhereTheCostIsUnbounded) {
  const NonlinearSolution solution =
      solve(of_one_unknown(0.0, [](const auto& x) { return -x[0]; }), {});
  EXPECT_EQ(solution.status, NonlinearStatus::kDiverged);
  EXPECT_GT(solution.values.at(0), 1e6);
  EXPECT_EQ(solution.objective, -solution.values.at(0));
}

// More is asked for than doubles hold: sin(x + y) + (x - y)^2 - 1.5 x + 2.5 y is least at
// (1/2 - pi/3, -1/2 - pi/3), where its slopes are some 1e-16.
TEST(NonlinearStatus, StalledWhereTheToleranceIsBelowRounding) {
  Program program;
  program.add({"x", {0.0, 0.0}, {{-1.5, 4.0}, {-3.0, 3.0}}, {1.0, 1.0}});
  program.add_cost(formula_cost({0, 1}, [](const auto& x) {
    using std::sin;
    return sin(x[0] + x[1]) + (x[0] - x[1]) * (x[0] - x[1]) - 1.5 * x[0] + 2.5 * x[1];
  }));
  const NonlinearSolution solution = solve(program, {.tolerance = 1e-30});
  EXPECT_EQ(solution.status, NonlinearStatus::kStalled);
  EXPECT_FALSE(solution.is_solved());
  EXPECT_TRUE(solution.multipliers.empty());
  EXPECT_NEAR(solution.values.at(0), 0.5 - std::numbers::pi / 3.0, 1e-7);
  EXPECT_NEAR(solution.values.at(1), -0.5 - std::numbers::pi / 3.0, 1e-7);
}

TEST(NonlinearStatus, BadNumbersAtTheStart) {
  const NonlinearSolution solution = solve(of_one_unknown(-1.0,
                                                          [](const auto& x) {
                                                            using std::sqrt;
                                                            return sqrt(x[0]);
                                                          }),
                                           {});
  EXPECT_EQ(solution.status, NonlinearStatus::kBadNumbers);
  EXPECT_EQ(solution.values, std::vector<double>{-1.0});
  EXPECT_EQ(solution.objective, HUGE_VAL);
  EXPECT_EQ(solution.largest_violation, HUGE_VAL);
}

TEST(NonlinearStatus, BadNumbersWhereNothingIsFree) {
  Program program;
  program.add({"x", {0.0}, {{-1.0, -1.0}}, {1.0}});
  program.add_rows(formula_rows({0}, {{0.0, 1.0}}, []<typename N>(const std::vector<N>& x) {
    using std::sqrt;
    return std::vector<N>{sqrt(x[0])};
  }));
  EXPECT_EQ(solve(program, {}).status, NonlinearStatus::kBadNumbers);
}

TEST(NonlinearStatus, BadNumbersOfADerivative) {
  const NonlinearSolution solution =
      solve(with_odd_cost([](double x) { return x * x; },
                          [](double) { return std::numeric_limits<double>::quiet_NaN(); }),
            {});
  EXPECT_EQ(solution.status, NonlinearStatus::kBadNumbers);
  EXPECT_EQ(solution.values, std::vector<double>{1.0});
  EXPECT_EQ(solution.objective, 1.0);
}

// x - 0.1 sqrt(x) has no values where full steps from 1 lead; least at x = 0.05^2.
TEST(NonlinearStatus, SolvedThoughTrialsHadBadNumbers) {
  bool was_bad = false;
  Program program;
  program.add({"x", {1.0}, {{}}, {1.0}});
  program.add_cost(formula_cost({0}, [&](const auto& x) {
    using std::sqrt;
    was_bad = was_bad || x[0] < 0.0;
    return x[0] - 0.1 * sqrt(x[0]);
  }));
  const NonlinearSolution solution = solve(program, {});
  EXPECT_EQ(solution.status, NonlinearStatus::kSolved);
  EXPECT_TRUE(was_bad);
  EXPECT_NEAR(solution.values.at(0), 0.0025, 1e-6);
}

// Two equations for one unknown, though they agree.
TEST(NonlinearStatus, OverdefinedWithMoreEquationsThanUnknowns) {
  Program program = of_one_unknown(3.0, [](const auto& x) { return x[0]; });
  program.add({"fixed", {7.0}, {{7.0, 7.0}}, {1.0}});
  program.add_rows(
      formula_rows({0, 1}, {{1.0, 1.0}, {2.0, 2.0}}, []<typename N>(const std::vector<N>& x) {
        return std::vector<N>{x[0] + 0.0 * x[1], 2.0 * x[0]};
      }));
  const NonlinearSolution solution = solve(program, {});
  EXPECT_EQ(solution.status, NonlinearStatus::kOverdefined);
  EXPECT_EQ(solution.values, (std::vector<double>{3.0, 7.0}));
  EXPECT_EQ(solution.largest_violation, 4.0);
}

TEST(NonlinearStatus, HasANameOfItsOwn) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(NonlinearStatus::kOverdefined); ++i) {
    names.insert(name_of(static_cast<NonlinearStatus>(i)));
  }
  EXPECT_EQ(names.size(), 10u);
  EXPECT_THROW(name_of(static_cast<NonlinearStatus>(10)), std::invalid_argument);
}

// Oracle: the cost of the start, which the first iterate is; of the solution, which the last is.
// The cost's scale, a power of 2, leaves no trace.
TEST(NonlinearIterates, AreShownFromTheStartToTheEnd) {
  Program program;
  program.add({"x", {-2.0, 1.0}, {{}, {}}, {1.0, 1.0}});
  const auto cost = []<typename N>(const std::vector<N>& x) {
    return std::vector<N>{kRosenbrock2(x)};
  };
  program.add_cost(std::make_unique<FormulaRows<decltype(cost)>>(
      std::vector<int>{0, 1}, std::vector<Bounds>{{}}, std::vector<double>{8.0}, cost));
  std::vector<NonlinearIterate> iterates;
  const NonlinearSolution solution =
      solve(program,
            {.on_iterate = [&](const NonlinearIterate& iterate) { iterates.push_back(iterate); }});
  ASSERT_EQ(iterates.size(), static_cast<std::size_t>(solution.iterations) + 1);
  EXPECT_EQ(iterates.front().objective, kValleyStart);
  EXPECT_EQ(iterates.back().objective, solution.objective);
  for (std::size_t i = 0; i < iterates.size(); ++i) {
    EXPECT_EQ(iterates[i].iteration, static_cast<int>(i));
  }
}

// A search that restores feasibility shows its own cost and violation all the while, not those of
// restoring it. Oracle: whatever x^2 <= -1 was evaluated at, noted by the row itself.
TEST(NonlinearIterates, AreOfTheProgramWhileFeasibilityIsRestored) {
  std::map<double, double> violations;  // by x, which is the cost
  Program program = of_one_unknown(3.0, [](const auto& x) { return x[0]; });
  program.add_rows(formula_rows({0}, {{-HUGE_VAL, -1.0}}, [&]<typename N>(const std::vector<N>& x) {
    if constexpr (std::is_same_v<N, double>) violations[x[0]] = x[0] * x[0] + 1.0;
    return std::vector<N>{x[0] * x[0]};
  }));
  const auto look = [&](const NonlinearIterate& iterate) {
    ASSERT_TRUE(violations.contains(iterate.objective)) << iterate.iteration;
    EXPECT_EQ(iterate.largest_violation, violations.at(iterate.objective)) << iterate.iteration;
  };
  EXPECT_EQ(solve(program, {.on_iterate = look}).status, NonlinearStatus::kLocallyInfeasible);
}

TEST(Nonlinear, IsDeterministic) {
  const NonlinearSolution once = solve(valley(), {}), again = solve(valley(), {});
  EXPECT_EQ(once.values, again.values);
  EXPECT_EQ(once.iterations, again.iterations);
}

TEST(Nonlinear, TimesDerivativesAsAPartOfTheWhole) {
  const NonlinearSolution solution = solve(valley(), {});
  EXPECT_GT(solution.derivative_seconds, 0.0);
  EXPECT_LE(solution.derivative_seconds, solution.seconds);
}

}  // namespace
}  // namespace torquewright::optimization
