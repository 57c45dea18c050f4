// SPDX-License-Identifier: Apache-2.0
#include "tests/optimization/nonlinear/hock_schittkowski/published_problem.hpp"

#include <cmath>

namespace torquewright::optimization {
namespace {

/// Rows that another object computes, on other scales.
class Rescaled final : public Rows {
 public:
  Rescaled(std::shared_ptr<const Rows> rows, std::vector<double> scales)
      : Rows(rows->name(), rows->variables(), rows->bounds(), std::move(scales)),
        rows_(std::move(rows)) {}

  void values(const VectorIn& x, VectorOut rows) const override { rows_->values(x, rows); }
  void slopes(const VectorIn& x, MatrixOut jacobian) const override { rows_->slopes(x, jacobian); }
  void curvatures(const VectorIn& x, const VectorIn& multipliers,
                  MatrixOut hessian) const override {
    rows_->curvatures(x, multipliers, hessian);
  }

 private:
  std::shared_ptr<const Rows> rows_;
};

/// 1, base, 1/base, 1, ...
std::vector<double> in_turns(std::size_t count, double base) {
  std::vector<double> scales;
  for (std::size_t i = 0; i < count; ++i) {
    scales.push_back(i % 3 == 0 ? 1.0 : i % 3 == 1 ? base : 1.0 / base);
  }
  return scales;
}

}  // namespace

std::vector<PublishedProblem> every_published_problem() {
  std::vector<PublishedProblem> problems;
  for (auto part :
       {problems_with_bounds, problems_with_equations, problems_with_equations_and_bounds,
        problems_in_the_plane, problems_in_space, problems_of_industry}) {
    for (PublishedProblem& problem : part()) problems.push_back(std::move(problem));
  }
  return problems;
}

Program program_of(const PublishedProblem& problem, const std::vector<double>& start,
                   const OtherScales& scales) {
  Program program;
  program.add({"x", start, problem.bounds, in_turns(start.size(), scales.of_variables)});
  program.add_cost(std::make_unique<Rescaled>(problem.cost, std::vector<double>{scales.of_cost}));
  if (problem.rows) {
    program.add_rows(std::make_unique<Rescaled>(
        problem.rows, in_turns(problem.rows->bounds().size(), scales.of_rows)));
  }
  return program;
}

}  // namespace torquewright::optimization
