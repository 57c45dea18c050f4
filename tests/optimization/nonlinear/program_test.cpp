// SPDX-License-Identifier: Apache-2.0
// What a program refuses, and the sentence that names it. Oracle: program.hpp.
#include "optimization/nonlinear/program.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "optimization/nonlinear/solve.hpp"
#include "tests/optimization/nonlinear/formula_rows.hpp"

namespace torquewright::optimization {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::string refusal_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

std::string refusal_of_set(std::vector<double> values, std::vector<Bounds> bounds,
                           std::vector<double> scales) {
  return refusal_of([&] { Program().add({"knee", values, bounds, scales}); });
}

std::unique_ptr<const Rows> sum_of(std::vector<int> variables, std::vector<Bounds> bounds,
                                   std::vector<double> scales) {
  const auto sum = []<typename N>(const std::vector<N>& x) {
    N total(0.0);
    for (const N& number : x) total += number;
    return std::vector<N>{total};
  };
  return std::make_unique<FormulaRows<decltype(sum)>>(std::move(variables), std::move(bounds),
                                                      std::move(scales), sum);
}

TEST(ProgramRefuses, VariablesThatAreNotSound) {
  EXPECT_EQ(refusal_of_set({1.0, 2.0}, {{}, {0.0, 3.0}}, {1.0, 1e-9}), "");
  EXPECT_EQ(refusal_of_set({1.0, 2.0}, {{}}, {1.0, 1.0}), "knee: 2 values, 1 bounds");
  EXPECT_EQ(refusal_of_set({1.0, 2.0}, {{}, {}}, {1.0}), "knee: 2 bounds, 1 scales");
  for (const double value : {kNaN, HUGE_VAL, -HUGE_VAL}) {
    EXPECT_EQ(refusal_of_set({1.0, value}, {{}, {}}, {1.0, 1.0}),
              "knee[1]: its value is not finite");
  }
  for (const double scale : {kNaN, HUGE_VAL, 0.0, -1.0}) {
    EXPECT_EQ(refusal_of_set({1.0}, {{}}, {scale}),
              "knee[0]: its scale is not positive and finite");
  }
  for (const Bounds bounds : {Bounds{1.0, 0.0}, Bounds{kNaN, 1.0}, Bounds{0.0, kNaN}}) {
    EXPECT_EQ(refusal_of_set({1.0}, {bounds}, {1.0}),
              "knee[0]: its bounds are crossed or no numbers");
  }
  for (const double end : {HUGE_VAL, -HUGE_VAL}) {
    EXPECT_EQ(refusal_of_set({1.0}, {{end, end}}, {1.0}), "knee[0]: no number lies in its bounds");
  }
}

TEST(ProgramRefuses, RowsThatAreNotSound) {
  Program program;
  EXPECT_EQ(program.add({"a", {0.0}, {{}}, {1.0}}), 0);
  EXPECT_EQ(program.add({"b", {0.0, 0.0}, {{}, {1.0, 1.0}}, {1.0, 1.0}}), 1);
  const auto refusal = [&](std::vector<int> variables, std::vector<Bounds> bounds,
                           std::vector<double> scales) {
    return refusal_of([&] { program.add_rows(sum_of(variables, bounds, scales)); });
  };
  EXPECT_EQ(refusal({0, 2}, {{0.0, 1.0}}, {2.0}), "");
  EXPECT_EQ(refusal({0, 2}, {{1.0, 1.0}}, {2.0}), "");
  EXPECT_EQ(refusal({0, 3}, {{}}, {1.0}), "formula[1]: the program has no variable 3");
  EXPECT_EQ(refusal({-1}, {{}}, {1.0}), "formula[0]: the program has no variable -1");
  EXPECT_EQ(refusal({1, 0, 1}, {{}}, {1.0}), "formula: variable 1 stands twice");
  EXPECT_EQ(refusal({0}, {{}}, {0.0}), "formula[0]: its scale is not positive and finite");
  EXPECT_EQ(refusal({0}, {{2.0, 1.0}}, {1.0}), "formula[0]: its bounds are crossed or no numbers");
  EXPECT_EQ(refusal({0}, {{}, {}}, {1.0}), "formula: 2 bounds, 1 scales");
  EXPECT_EQ(refusal_of([&] { program.add_rows(nullptr); }), "rows that are none");
  EXPECT_EQ(refusal_of([&] {
              program.add_cost(sum_of({0}, {{}, {}}, {1.0, 1.0}));
            }),
            "formula: a cost is one row");
  // What was refused was not added.
  EXPECT_EQ(program.variable_count(), 3);
  EXPECT_EQ(program.free_variable_count(), 2);
  EXPECT_EQ(program.row_count(), 2);
  EXPECT_EQ(program.equation_count(), 1);
  EXPECT_TRUE(program.costs().empty());
}

TEST(SolveRefuses, OptionsThatAreNoNumbersOrNegative) {
  Program program;
  program.add({"x", {0.0}, {{}}, {1.0}});
  const auto is_refused = [&](NonlinearOptions options) {
    return !refusal_of([&] { (void)solve(program, options); }).empty();
  };
  EXPECT_FALSE(is_refused({}));
  for (const double number : {0.0, -1.0, kNaN, HUGE_VAL}) {
    EXPECT_TRUE(is_refused({.tolerance = number}));
    EXPECT_TRUE(is_refused({.first_barrier = number}));
  }
  for (const double seconds : {-1.0, kNaN}) EXPECT_TRUE(is_refused({.most_seconds = seconds}));
  EXPECT_TRUE(is_refused({.most_iterations = -1}));
}

}  // namespace
}  // namespace torquewright::optimization
