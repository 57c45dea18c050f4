// SPDX-License-Identifier: Apache-2.0
// How long a quadratic program takes of the size that a biped's controller asks for in each
// millisecond: 48 unknowns, 34 equations, 40 bounds; without memory of the one before, and with it
// where the next is close by.
#include <benchmark/benchmark.h>

#include <random>

#include "optimization/quadratic/solver.hpp"

namespace torquewright::optimization {
namespace {

constexpr Eigen::Index kUnknowns = 48, kEquations = 34, kBounds = 40;

QuadraticProgram biped_sized() {
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> drawn(-1.0, 1.0);
  const auto matrix = [&](Eigen::Index rows) {
    return Eigen::MatrixXd::NullaryExpr(rows, kUnknowns, [&] { return drawn(engine); }).eval();
  };
  const Eigen::MatrixXd root = matrix(40);
  QuadraticProgram program;
  program.cost = root.transpose() * root + 1e-4 * Eigen::MatrixXd::Identity(kUnknowns, kUnknowns);
  program.slope = 10.0 * root.transpose() * Eigen::VectorXd::Ones(40);
  program.rows = matrix(kEquations + kBounds);
  program.lower.setZero(kEquations + kBounds);
  program.upper.setZero(kEquations + kBounds);
  program.lower.tail(kBounds).setConstant(-1.0);
  program.upper.tail(kBounds).setConstant(2.0);
  return program;
}

void solve(benchmark::State& state, bool remembers) {
  QuadraticProgram program = biped_sized();
  QuadraticSolver solver;
  double steps = 0.0, solves = 0.0;
  for (auto _ : state) {
    if (!remembers) solver.forget();
    program.slope *= static_cast<int>(solves) % 2 == 0 ? 1.001 : 1.0 / 1.001;
    const QuadraticSolution& solution = solver.solve(program);
    if (solution.status != QuadraticStatus::kSolved) state.SkipWithError("not solved");
    steps += solution.steps;
    ++solves;
  }
  state.counters["steps"] = steps / solves;
}

BENCHMARK_CAPTURE(solve, without_memory, false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve, after_one_close_by, true)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace torquewright::optimization

BENCHMARK_MAIN();
