// SPDX-License-Identifier: Apache-2.0
// Blocks that share unknowns, in whatever order. Oracle: derivatives by hand.
#include "optimization/nonlinear/assembly.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "tests/optimization/nonlinear/formula_rows.hpp"

namespace torquewright::optimization {
namespace {

using Entries = std::map<std::pair<int, int>, double>;

Entries entries_of(const std::vector<Place>& places, const std::vector<double>& values) {
  Entries entries;
  for (std::size_t k = 0; k < places.size(); ++k) {
    EXPECT_TRUE(entries.emplace(std::pair(places[k].row, places[k].column), values[k]).second)
        << "an element stands twice";
  }
  return entries;
}

void expect_near(const Entries& entries, const Entries& expected) {
  ASSERT_EQ(entries.size(), expected.size());
  for (const auto& [place, value] : expected) {
    ASSERT_TRUE(entries.contains(place)) << place.first << " " << place.second;
    EXPECT_NEAR(entries.at(place), value, 1e-14 * std::max(1.0, std::abs(value)))
        << place.first << " " << place.second;
  }
}

/// 3 a - b, counting who asks for its slopes.
class CountingRows final : public Rows {
 public:
  CountingRows(std::vector<int> variables, int& calls)
      : Rows("counting", std::move(variables), {{}}, {2.0}), calls_(calls) {}
  void values(const VectorIn& x, VectorOut rows) const override { rows(0) = 3.0 * x(0) - x(1); }
  void slopes(const VectorIn&, MatrixOut jacobian) const override {
    ++calls_;
    jacobian << 3.0, -1.0;
  }
  void curvatures(const VectorIn&, const VectorIn&, MatrixOut) const override {
    FAIL() << "rows that are affine were asked for curvatures";
  }
  bool is_affine() const override { return true; }

 private:
  int& calls_;
};

/// Unknowns a b c d on scales 2, 1, 0.5, 4; rows c^2 a (over 10), a b (over 1), 3 d - a (over 2);
/// costs a^2 (scale 5) and b c (scale 3).
class SharedUnknowns : public testing::Test {
 protected:
  SharedUnknowns() {
    program_.add({"ab", {1.0, 2.0}, {{}, {0.0, 9.0}}, {2.0, 1.0}});
    program_.add({"cd", {3.0, 4.0}, {{}, {}}, {0.5, 4.0}});
    const auto rows = []<typename N>(const std::vector<N>& x) {
      return std::vector<N>{x[0] * x[0] * x[1], x[1] * x[2]};
    };
    program_.add_rows(std::make_unique<FormulaRows<decltype(rows)>>(
        std::vector<int>{2, 0, 1}, std::vector<Bounds>{{0.0, 1.0}, {}},
        std::vector<double>{10.0, 1.0}, rows));
    program_.add_rows(std::make_unique<CountingRows>(std::vector<int>{3, 0}, calls_));
    const auto square = []<typename N>(const std::vector<N>& x) {
      return std::vector<N>{x[0] * x[0]};
    };
    program_.add_cost(std::make_unique<FormulaRows<decltype(square)>>(
        std::vector<int>{0}, std::vector<Bounds>{{}}, std::vector<double>{5.0}, square));
    const auto product = []<typename N>(const std::vector<N>& x) {
      return std::vector<N>{x[0] * x[1]};
    };
    program_.add_cost(std::make_unique<FormulaRows<decltype(product)>>(
        std::vector<int>{2, 1}, std::vector<Bounds>{{}}, std::vector<double>{3.0}, product));
  }

  int calls_ = 0;
  Program program_;
  std::vector<double> here_ = {0.5, 2.0, 6.0, 1.0};  ///< a b c d = 1 2 3 4.
};

TEST_F(SharedUnknowns, AreScaledAndSummed) {
  Assembly assembly(program_);
  EXPECT_EQ(assembly.objective_scale(), 5.0);
  const Evaluation& here = assembly.at(here_);
  EXPECT_EQ(here.values, (std::vector<double>{1.0, 2.0, 3.0, 4.0}));
  EXPECT_EQ(here.objective, 7.0);
  EXPECT_EQ(here.rows, (std::vector<double>{0.9, 2.0, 5.5}));
  EXPECT_EQ(here.largest_violation, 0.8);  // 9 of 1, over 10
  EXPECT_TRUE(here.is_finite);
  std::vector<double> gradient(4);
  ASSERT_TRUE(assembly.gradient(here_, gradient));
  const std::vector<double> expected = {2.0 * 2.0 / 5.0, 3.0 / 5.0, 2.0 * 0.5 / 5.0, 0.0};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(gradient[i], expected[i], 1e-15);
}

TEST_F(SharedUnknowns, HaveEachElementOnce) {
  Assembly assembly(program_);
  std::vector<double> jacobian(assembly.jacobian_places().size());
  ASSERT_TRUE(assembly.jacobian(here_, jacobian));
  expect_near(entries_of(assembly.jacobian_places(), jacobian), {{{0, 0}, 9.0 * 2.0 / 10.0},
                                                                 {{0, 1}, 0.0},
                                                                 {{0, 2}, 6.0 * 0.5 / 10.0},
                                                                 {{1, 0}, 2.0 * 2.0},
                                                                 {{1, 1}, 1.0},
                                                                 {{1, 2}, 0.0},
                                                                 {{2, 0}, -1.0 * 2.0 / 2.0},
                                                                 {{2, 3}, 3.0 * 4.0 / 2.0}});
  std::vector<double> hessian(assembly.hessian_places().size());
  const std::vector<double> multipliers = {20.0, 3.0, 7.0};
  ASSERT_TRUE(assembly.hessian(here_, 10.0, multipliers, hessian));
  expect_near(entries_of(assembly.hessian_places(), hessian),
              {{{0, 0}, 2.0 * 2.0 * 2.0 * 10.0 / 5.0},
               {{1, 0}, 3.0 * 2.0},
               {{1, 1}, 0.0},
               {{2, 0}, 6.0 * 0.5 * 2.0 * 20.0 / 10.0},
               {{2, 1}, 0.5 * 10.0 / 5.0},
               {{2, 2}, 2.0 * 0.5 * 0.5 * 20.0 / 10.0}});
  // Alone: the objective's, then nothing.
  ASSERT_TRUE(assembly.hessian(here_, 10.0, std::vector<double>(3, 0.0), hessian));
  EXPECT_EQ(entries_of(assembly.hessian_places(), hessian).at({1, 0}), 0.0);
  ASSERT_TRUE(assembly.hessian(here_, 0.0, std::vector<double>(3, 0.0), hessian));
  EXPECT_EQ(hessian, std::vector<double>(hessian.size(), 0.0));
}

TEST_F(SharedUnknowns, AskAffineRowsOnceForTheirSlopes) {
  Assembly assembly(program_);
  std::vector<double> jacobian(assembly.jacobian_places().size());
  for (int i = 0; i < 3; ++i) {
    here_[0] += 1.0;
    ASSERT_TRUE(assembly.jacobian(here_, jacobian));
    EXPECT_EQ(entries_of(assembly.jacobian_places(), jacobian).at({2, 3}), 6.0);
  }
  EXPECT_EQ(calls_, 1);
}

TEST_F(SharedUnknowns, StayWithinTheirBounds) {
  Assembly assembly(program_);
  EXPECT_EQ(assembly.at(std::vector<double>{0.5, -1e-9, 6.0, 1.0}).values[1], 0.0);
  EXPECT_EQ(assembly.at(std::vector<double>{0.5, 9.1, 6.0, 1.0}).values[1], 9.0);
  EXPECT_EQ(assembly.at(std::vector<double>{-7.0, 9.0, 6.0, 1.0}).values[0], -14.0);
}

/// What sqrt is below 0 and its slope at 0.
TEST(AssemblyOfBadNumbers, SaysSo) {
  Program program;
  program.add({"x", {1.0}, {{}}, {1.0}});
  program.add_rows(formula_rows({0}, {{}}, []<typename N>(const std::vector<N>& x) {
    using std::sqrt;
    return std::vector<N>{sqrt(x[0])};
  }));
  Assembly assembly(program);
  std::vector<double> entry(1);
  EXPECT_TRUE(assembly.at(std::vector<double>{4.0}).is_finite);
  EXPECT_TRUE(assembly.jacobian(std::vector<double>{4.0}, entry));
  EXPECT_EQ(entry[0], 0.25);
  EXPECT_TRUE(assembly.at(std::vector<double>{0.0}).is_finite);
  EXPECT_FALSE(assembly.jacobian(std::vector<double>{0.0}, entry));
  EXPECT_FALSE(assembly.hessian(std::vector<double>{0.0}, 1.0, std::vector<double>{1.0}, entry));
  EXPECT_FALSE(assembly.at(std::vector<double>{-1.0}).is_finite);
}

}  // namespace
}  // namespace torquewright::optimization
