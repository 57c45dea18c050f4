// SPDX-License-Identifier: Apache-2.0
#include "optimization/quadratic/solver.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "optimization/nonlinear/solve.hpp"
#include "tests/optimization/quadratic/first_order.hpp"

namespace torquewright::optimization {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kNoBound = std::numeric_limits<double>::infinity();
/// Condition of the drawn numbers, some 1e4, times round-off and its hundred sums.
constexpr double kError = 1e-8;

MatrixXd drawn_matrix(oracles::Dice& dice, Index rows, Index columns) {
  MatrixXd out(rows, columns);
  for (Index i = 0; i < out.size(); ++i) out.data()[i] = test::uniform(dice, -1.0, 1.0);
  return out;
}

/// Of any number of unknowns up to 12: equations, rows bounded below, above or both, some twice,
/// and a cost whose rank may be less than the unknowns. About a point that obeys all of them; some
/// bounds lie on it.
QuadraticProgram drawn_program(oracles::Dice& dice) {
  const Index n = dice.between(1, 12), rank = dice.between(1, n + 2), m = dice.between(0, 20);
  const MatrixXd root = drawn_matrix(dice, rank, n);
  QuadraticProgram program;
  program.rows = drawn_matrix(dice, m, n);
  program.cost = root.transpose() * root;
  const VectorXd inside = drawn_matrix(dice, n, 1);
  // In the range of the cost where this is flat: then it has a minimum.
  program.slope = 3.0 * root.transpose() * drawn_matrix(dice, rank, 1);
  program.lower.setConstant(m, -kNoBound);
  program.upper.setConstant(m, kNoBound);
  for (Index row = 0; row < m; ++row) {
    if (row > 0 && dice.between(0, 5) == 0) program.rows.row(row) = -program.rows.row(row - 1);
    const double value = program.rows.row(row).dot(inside);
    const std::int64_t kind = dice.between(0, 9);
    const double below = dice.between(0, 3) == 0 ? 0.0 : test::uniform(dice, 0.0, 1.0);
    if (kind != 1 && kind != 2) program.lower[row] = value - below;
    if (kind > 0 && kind != 3) program.upper[row] = value + test::uniform(dice, 0.0, 1.0);
    if (kind >= 8) program.lower[row] = program.upper[row] = value;
  }
  return program;
}

/// The same for Ipopt.
class Affine final : public Rows {
 public:
  Affine(std::vector<int> variables, const QuadraticProgram& program, std::vector<Bounds> bounds)
      : Rows("rows", std::move(variables), bounds, std::vector<double>(bounds.size(), 1.0)),
        program_(program) {}
  void values(const VectorIn& x, VectorOut rows) const override { rows = program_.rows * x; }
  void slopes(const VectorIn&, MatrixOut jacobian) const override { jacobian = program_.rows; }
  void curvatures(const VectorIn&, const VectorIn&, MatrixOut hessian) const override {
    hessian.setZero();
  }
  bool is_affine() const override { return true; }

 private:
  const QuadraticProgram& program_;
};

class Cost final : public Rows {
 public:
  Cost(std::vector<int> variables, const QuadraticProgram& program)
      : Rows("cost", std::move(variables), {{}}, {1.0}), program_(program) {}
  void values(const VectorIn& x, VectorOut rows) const override { rows[0] = cost_of(program_, x); }
  void slopes(const VectorIn& x, MatrixOut jacobian) const override {
    jacobian = (program_.cost * x + program_.slope).transpose();
  }
  void curvatures(const VectorIn&, const VectorIn& multipliers, MatrixOut hessian) const override {
    hessian = multipliers[0] * program_.cost;
  }

 private:
  const QuadraticProgram& program_;
};

NonlinearSolution by_ipopt(const QuadraticProgram& program) {
  const auto n = static_cast<std::size_t>(program.slope.size());
  Program same;
  same.add({"x", std::vector<double>(n, 0.0), std::vector<Bounds>(n), std::vector<double>(n, 1.0)});
  std::vector<int> all;
  for (std::size_t i = 0; i < n; ++i) all.push_back(static_cast<int>(i));
  std::vector<Bounds> bounds;
  for (Index row = 0; row < program.rows.rows(); ++row) {
    bounds.push_back({program.lower[row], program.upper[row]});
  }
  if (!bounds.empty()) same.add_rows(std::make_unique<Affine>(all, program, bounds));
  same.add_cost(std::make_unique<Cost>(all, program));
  return solve(same, {});
}

TEST(QuadraticSolver, MeetsTheFirstOrderConditions) {
  oracles::Dice dice(1);
  QuadraticSolver solver;
  for (int sample = 0; sample < 2000; ++sample) {
    const QuadraticProgram program = drawn_program(dice);
    SCOPED_TRACE(sample);
    expect_optimal(program, solver.solve(program), kError);
    if (testing::Test::HasFailure()) return;
  }
}

// Oracle: Ipopt, whose interior point shares nothing with an active set: it finds nothing that is
// cheaper than its conditions' 1e-7, and ends near by, from within.
TEST(QuadraticSolver, FindsWhatIpoptFinds) {
  oracles::Dice dice(2);
  int compared = 0;
  for (int sample = 0; sample < 60; ++sample) {
    const QuadraticProgram program = drawn_program(dice);
    const NonlinearSolution theirs = by_ipopt(program);
    // More equations than unknowns, or dependent ones, are not for it.
    if (theirs.status != NonlinearStatus::kSolved) continue;
    ++compared;
    QuadraticSolver solver;
    const QuadraticSolution& ours = solver.solve(program);
    expect_optimal(program, ours, kError);
    const double size = 1.0 + std::abs(theirs.objective) + ours.multipliers.lpNorm<1>();
    EXPECT_LE(cost_of(program, ours.x), theirs.objective + 1e-6 * size) << sample;
    EXPECT_GE(cost_of(program, ours.x), theirs.objective - 1e-4 * size) << sample;
  }
  EXPECT_GE(compared, 40);
}

// Oracle: a solver without memory. What is close by has nearly the same active bounds, so that the
// one with memory takes fewer steps.
TEST(QuadraticSolver, BeginsWithTheBoundsThatWereActive) {
  oracles::Dice dice(3);
  int cold_steps = 0, warm_steps = 0;
  for (int sample = 0; sample < 50; ++sample) {
    QuadraticProgram program = drawn_program(dice);
    QuadraticSolver warm;
    (void)warm.solve(program);
    for (int later = 0; later < 5; ++later) {
      program.slope *= 1.0 + 1e-3 * test::uniform(dice, -1.0, 1.0);
      QuadraticSolver cold;
      expect_optimal(program, warm.solve(program), kError);
      ASSERT_EQ(cold.solve(program).status, QuadraticStatus::kSolved);
      EXPECT_NEAR(cost_of(program, warm.solve(program).x), cost_of(program, cold.solve(program).x),
                  kError * (1.0 + std::abs(cost_of(program, cold.solve(program).x))));
      QuadraticSolver anew;
      cold_steps += anew.solve(program).steps;
      warm_steps += warm.solve(program).steps;
    }
  }
  EXPECT_GT(cold_steps, 500);
  EXPECT_LT(5 * warm_steps, cold_steps);
}

QuadraticProgram rows_of(const QuadraticProgram& program, const std::vector<Index>& rows,
                         Index without) {
  QuadraticProgram part{program.cost, program.slope, {}, {}, {}};
  const auto count = static_cast<Index>(rows.size()) - (without >= 0 ? 1 : 0);
  part.rows.resize(count, program.slope.size());
  part.lower.resize(count);
  part.upper.resize(count);
  Index place = 0;
  for (const Index row : rows) {
    if (row == without) continue;
    part.rows.row(place) = program.rows.row(row);
    part.lower[place] = program.lower[row];
    part.upper[place++] = program.upper[row];
  }
  return part;
}

// What is named contradicts itself, and no less of it does.
TEST(QuadraticSolver, NamesTheRowsThatContradictEachOther) {
  oracles::Dice dice(4);
  int found = 0, with_equations = 0;
  for (int sample = 0; sample < 400; ++sample) {
    QuadraticProgram program = drawn_program(dice);
    // Bounds that are moved about no longer need to leave a point.
    for (Index row = 0; row < program.rows.rows(); ++row) {
      const double by = test::uniform(dice, -1.5, 1.5);
      program.lower[row] += by;
      program.upper[row] += by;
    }
    QuadraticSolver solver;
    const QuadraticSolution& whole = solver.solve(program);
    if (whole.status == QuadraticStatus::kSolved) {
      expect_optimal(program, whole, kError);
      continue;
    }
    ASSERT_EQ(whole.status, QuadraticStatus::kInfeasible) << sample;
    ++found;
    const std::vector<Index> named = whole.contradicting;
    ASSERT_FALSE(named.empty());
    for (const Index row : named) {
      with_equations += program.lower[row] == program.upper[row] ? 1 : 0;
      QuadraticSolver other;
      EXPECT_EQ(other.solve(rows_of(program, named, row)).status, QuadraticStatus::kSolved)
          << sample << " without " << row;
    }
    QuadraticSolver other;
    EXPECT_EQ(other.solve(rows_of(program, named, -1)).status, QuadraticStatus::kInfeasible);
  }
  EXPECT_GE(found, 100);
  EXPECT_GE(with_equations, 20);
}

// By hand: x + y >= 3 with x <= 1, y <= 1; z is free of them.
TEST(QuadraticSolver, NamesNoRowThatIsNotToBlame) {
  QuadraticProgram program{MatrixXd::Identity(3, 3), VectorXd::Zero(3), MatrixXd::Zero(4, 3),
                           VectorXd::Constant(4, -kNoBound), VectorXd::Ones(4)};
  program.rows.topRows(3).setIdentity();
  program.rows.row(3) << 1, 1, 0;
  program.lower[3] = 3.0;
  program.upper[3] = kNoBound;
  QuadraticSolver solver;
  const QuadraticSolution& found = solver.solve(program);
  EXPECT_EQ(found.status, QuadraticStatus::kInfeasible);
  EXPECT_EQ(found.contradicting, (std::vector<Index>{0, 1, 3}));
  program.lower[2] = 2.0;  // above its own upper bound
  EXPECT_EQ(solver.solve(program).contradicting, (std::vector<Index>{2}));
}

// (x - y)^2 - x - y falls along (1, 1), until a bound ends it.
TEST(QuadraticSolver, SaysWhereTheCostFallsForEver) {
  QuadraticProgram program{2.0 * (MatrixXd(2, 2) << 1, -1, -1, 1).finished(), -VectorXd::Ones(2),
                           (MatrixXd(1, 2) << 1, -1).finished(), VectorXd::Constant(1, -kNoBound),
                           VectorXd::Ones(1)};
  QuadraticSolver solver;
  const QuadraticSolution& found = solver.solve(program);
  ASSERT_EQ(found.status, QuadraticStatus::kUnbounded) << name_of(found.status);
  EXPECT_NEAR(found.direction[0], std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(found.direction[1], std::sqrt(0.5), 1e-6);
  program.rows << 1, 1;
  program.upper << 4.0;
  expect_optimal(program, solver.solve(program), kError);
  EXPECT_NEAR(solver.solve(program).x[0], 2.0, kError);
  // Without any curvature: a linear program, down to a corner, and none.
  program.cost.setZero();
  program.rows = MatrixXd::Identity(2, 2);
  program.lower.setConstant(2, -kNoBound);
  program.upper.setConstant(2, 3.0);
  expect_optimal(program, solver.solve(program), kError);
  EXPECT_NEAR((solver.solve(program).x - VectorXd::Constant(2, 3.0)).norm(), 0.0, kError);
  program.upper[1] = kNoBound;
  EXPECT_EQ(solver.solve(program).status, QuadraticStatus::kUnbounded);
}

// x y has no least value; where x = y it is x^2.
TEST(QuadraticSolver, AsksForConvexityWhereEquationsLeaveRoom) {
  QuadraticProgram program{(MatrixXd(2, 2) << 0, 1, 1, 0).finished(), VectorXd::Ones(2),
                           MatrixXd(0, 2), VectorXd(0), VectorXd(0)};
  QuadraticSolver solver;
  EXPECT_EQ(solver.solve(program).status, QuadraticStatus::kNotConvex);
  program.rows = (MatrixXd(1, 2) << 1, -1).finished();
  program.lower = program.upper = VectorXd::Zero(1);
  expect_optimal(program, solver.solve(program), kError);
  EXPECT_NEAR(solver.solve(program).x[0], -1.0, kError);
  program.rows << 1, 1;
  EXPECT_EQ(solver.solve(program).status, QuadraticStatus::kNotConvex);
}

// Oracle: the change of the optimum when a bound is moved, by central differences, is minus the
// multiplier.
TEST(QuadraticSolver, MultipliersAreMinusTheSlopeOfTheOptimum) {
  oracles::Dice dice(5);
  int at_lower = 0, at_upper = 0, at_equations = 0;
  for (int sample = 0; sample < 100; ++sample) {
    QuadraticProgram program = drawn_program(dice);
    program.cost += MatrixXd::Identity(program.cost.rows(), program.cost.cols());
    QuadraticSolver solver;
    const VectorXd multipliers = solver.solve(program).multipliers;
    for (Index row = 0; row < multipliers.size(); ++row) {
      constexpr double kStep = 1e-5;
      if (std::abs(multipliers[row]) < 0.1) continue;  // a moved bound might not hold
      const bool is_equation = program.lower[row] == program.upper[row];
      const auto moved = [&](double by) {
        QuadraticProgram other = program;
        if (multipliers[row] < 0.0 || is_equation) other.lower[row] += by;
        if (multipliers[row] > 0.0 || is_equation) other.upper[row] += by;
        QuadraticSolver one;
        const QuadraticSolution& found = one.solve(other);
        return found.status == QuadraticStatus::kSolved ? cost_of(other, found.x) : NAN;
      };
      const double slope = (moved(kStep) - moved(-kStep)) / (2.0 * kStep);
      // A degenerate corner has other slopes to either side: no one multiplier is theirs.
      if (!std::isfinite(slope) ||
          std::abs(moved(kStep) + moved(-kStep) - 2.0 * moved(0.0)) > 1e-3 * kStep) {
        continue;
      }
      EXPECT_NEAR(slope, -multipliers[row], 1e-4 * (1.0 + std::abs(slope))) << sample;
      (is_equation ? at_equations : multipliers[row] > 0.0 ? at_upper : at_lower) += 1;
    }
  }
  EXPECT_GE(std::min({at_lower, at_upper, at_equations}), 20);
}

TEST(QuadraticSolver, RefusesWhatIsNoProgram) {
  QuadraticProgram program{MatrixXd::Identity(2, 2), VectorXd::Zero(2), MatrixXd::Identity(1, 2),
                           VectorXd::Zero(1), VectorXd::Ones(1)};
  QuadraticSolver solver;
  EXPECT_EQ(solver.solve(program).status, QuadraticStatus::kSolved);
  QuadraticProgram other = program;
  other.lower.setZero(2);
  EXPECT_THROW((void)solver.solve(other), std::invalid_argument);
  other = program;
  other.slope[0] = NAN;
  EXPECT_THROW((void)solver.solve(other), std::invalid_argument);
  other = program;
  other.lower[0] = kNoBound;
  EXPECT_THROW((void)solver.solve(other), std::invalid_argument);
}

}  // namespace
}  // namespace torquewright::optimization
