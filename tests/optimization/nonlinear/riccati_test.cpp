// SPDX-License-Identifier: Apache-2.0
// A linear-quadratic control problem, stated stage by stage in sparse rows:
//   minimise  sum_k 1/2 (x_k' Q x_k + u_k' R u_k) + 1/2 x_N' Q_N x_N,   x_k+1 = A_k x_k + B_k u_k
// Oracle: the Riccati recursion, u_k = -K_k x_k with
//   K_k = (R + B' P_k+1 B)^-1 B' P_k+1 A,   P_k = Q + A' P_k+1 (A - B K_k),   P_N = Q_N,
// and the costates P_k x_k, which are the multipliers of A x + B u - x_k+1 = 0.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "optimization/nonlinear/assembly.hpp"
#include "optimization/nonlinear/solve.hpp"

namespace torquewright::optimization {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kStages = 80, kStates = 4, kControls = 2;

/// matrix x = 0.
class LinearRows final : public Rows {
 public:
  LinearRows(std::vector<int> variables, MatrixXd matrix, std::vector<double> scales)
      : Rows("dynamics", std::move(variables),
             std::vector<Bounds>(static_cast<std::size_t>(matrix.rows()), {0.0, 0.0}),
             std::move(scales)),
        matrix_(std::move(matrix)) {}
  void values(const VectorIn& x, VectorOut rows) const override { rows = matrix_ * x; }
  void slopes(const VectorIn&, MatrixOut jacobian) const override { jacobian = matrix_; }
  void curvatures(const VectorIn&, const VectorIn&, MatrixOut) const override {
    FAIL() << "rows that are affine were asked for curvatures";
  }
  bool is_affine() const override { return true; }

 private:
  MatrixXd matrix_;
};

/// x' weight x / 2.
class QuadraticCost final : public Rows {
 public:
  QuadraticCost(std::vector<int> variables, MatrixXd weight, double scale)
      : Rows("cost", std::move(variables), {{}}, {scale}), weight_(std::move(weight)) {}
  void values(const VectorIn& x, VectorOut rows) const override {
    rows(0) = 0.5 * x.dot(weight_ * x);
  }
  void slopes(const VectorIn& x, MatrixOut jacobian) const override {
    jacobian = (weight_ * x).transpose();
  }
  void curvatures(const VectorIn&, const VectorIn& multipliers, MatrixOut hessian) const override {
    hessian = multipliers(0) * weight_;
  }

 private:
  MatrixXd weight_;
};

struct ControlProblem {
  std::vector<MatrixXd> A, B;  ///< By stage.
  MatrixXd Q, R, Q_end;
  VectorXd first;  ///< State.
};

/// Two coupled oscillators, one of them unstable, whose couplings and inputs change from stage to
/// stage.
ControlProblem oscillators() {
  ControlProblem problem;
  for (int k = 0; k < kStages; ++k) {
    MatrixXd A(kStates, kStates), B(kStates, kControls);
    const double coupling = 0.05 * std::cos(0.2 * k);
    A << 1.0, 0.1, 0.0, 0.0,            //
        -0.15, 0.98, coupling, 0.0,     //
        0.0, 0.0, 1.0, 0.1,             //
        -coupling, 0.0, 0.12, 1.01;     //
    B << 0.005, 0.0,                    //
        0.1, 0.02 * std::sin(0.1 * k),  //
        0.0, 0.004,                     //
        0.01, 0.08;
    problem.A.push_back(A);
    problem.B.push_back(B);
  }
  problem.Q = MatrixXd::Identity(kStates, kStates) * 0.3;
  problem.Q(0, 1) = problem.Q(1, 0) = 0.1;
  problem.R = MatrixXd::Identity(kControls, kControls) * 0.05;
  problem.R(0, 1) = problem.R(1, 0) = 0.01;
  problem.Q_end = MatrixXd::Identity(kStates, kStates) * 5.0;
  problem.first = VectorXd(kStates);
  problem.first << 1.0, -0.5, 0.3, 0.8;
  return problem;
}

struct Trajectory {
  std::vector<VectorXd> states, controls, costates;  ///< Costates from stage 1 on.
  double cost = 0.0;
};

Trajectory by_riccati(const ControlProblem& problem) {
  std::vector<MatrixXd> P(kStages + 1), K(kStages);
  P[kStages] = problem.Q_end;
  for (std::size_t k = kStages; k-- > 0;) {
    const MatrixXd &A = problem.A[k], &B = problem.B[k];
    const MatrixXd curvature = problem.R + B.transpose() * P[k + 1] * B;
    K[k] = curvature.ldlt().solve(B.transpose() * P[k + 1] * A);
    P[k] = problem.Q + A.transpose() * P[k + 1] * (A - B * K[k]);
  }
  Trajectory best;
  best.cost = 0.5 * problem.first.dot(P[0] * problem.first);
  best.states.push_back(problem.first);
  for (std::size_t k = 0; k < kStages; ++k) {
    best.controls.emplace_back(-K[k] * best.states[k]);
    best.states.emplace_back(problem.A[k] * best.states[k] + problem.B[k] * best.controls[k]);
    best.costates.emplace_back(P[k + 1] * best.states[k + 1]);
  }
  return best;
}

std::vector<int> numbers_from(int first, int count) {
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

std::vector<int> joined(std::vector<int> a, const std::vector<int>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Stage by stage its state and its control, on scales from 0.2 to 4; the first state is fixed by
/// its bounds.
Program program_of(const ControlProblem& problem) {
  const std::vector<double> state_scales = {1.0, 2.0, 0.5, 4.0}, row_scales = {0.5, 3.0, 1.0, 2.0};
  Program program;
  std::vector<std::vector<int>> states, controls;
  for (int k = 0; k <= kStages; ++k) {
    VariableSet state = {"state", std::vector<double>(kStates, 0.0), std::vector<Bounds>(kStates),
                         state_scales};
    if (k == 0) {
      state.values.assign(problem.first.begin(), problem.first.end());
      for (std::size_t i = 0; i < kStates; ++i)
        state.bounds[i] = {state.values[i], state.values[i]};
    }
    states.push_back(numbers_from(program.add(state), kStates));
    if (k == kStages) break;
    controls.push_back(
        numbers_from(program.add({"control", {0.0, 0.0}, {{}, {}}, {0.2, 1.0}}), kControls));
  }
  for (std::size_t k = 0; k < kStages; ++k) {
    program.add_cost(std::make_unique<QuadraticCost>(states[k], problem.Q, 1.0));
    program.add_cost(std::make_unique<QuadraticCost>(controls[k], problem.R, 2.0));
    MatrixXd matrix(kStates, kStates + kControls + kStates);
    matrix << problem.A[k], problem.B[k], -MatrixXd::Identity(kStates, kStates);
    program.add_rows(std::make_unique<LinearRows>(
        joined(joined(states[k], controls[k]), states[k + 1]), matrix, row_scales));
  }
  program.add_cost(std::make_unique<QuadraticCost>(states.back(), problem.Q_end, 0.1));
  return program;
}

// Two roundings a stage, times condition numbers of some 1e3.
constexpr double kRounding = 1e-10;

TEST(LinearQuadraticControl, MeetsTheRiccatiSolutionInOneStep) {
  const ControlProblem problem = oscillators();
  const Trajectory best = by_riccati(problem);
  const NonlinearSolution solution = solve(program_of(problem), {});
  ASSERT_EQ(solution.status, NonlinearStatus::kSolved);
  // Newton's step is exact where costs are quadratic and rows are equations.
  EXPECT_EQ(solution.iterations, 1);
  EXPECT_NEAR(solution.objective, best.cost, kRounding * best.cost);
  const double* next = solution.values.data();
  for (std::size_t k = 0; k <= kStages; ++k) {
    for (const double state : best.states[k]) EXPECT_NEAR(*next++, state, kRounding) << k;
    if (k == kStages) break;
    for (const double control : best.controls[k]) EXPECT_NEAR(*next++, control, kRounding) << k;
  }
  ASSERT_EQ(solution.multipliers.size(), static_cast<std::size_t>(kStages * kStates));
  next = solution.multipliers.data();
  for (const VectorXd& costate : best.costates) {
    for (const double element : costate) EXPECT_NEAR(*next++, element, kRounding * 10.0);
  }
}

TEST(LinearQuadraticControl, IsAsSparseAsItsStages) {
  const Program program = program_of(oscillators());
  const Assembly assembly(program);
  EXPECT_EQ(assembly.jacobian_places().size(),
            static_cast<std::size_t>(kStages * kStates * (2 * kStates + kControls)));
  // Lower triangles of Q and R.
  EXPECT_EQ(assembly.hessian_places().size(),
            static_cast<std::size_t>((kStages + 1) * 10 + kStages * 3));
}

}  // namespace
}  // namespace torquewright::optimization
