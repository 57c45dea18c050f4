// SPDX-License-Identifier: Apache-2.0
#include "optimization/nonlinear/first_order.hpp"

#include <cmath>

namespace torquewright::optimization {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd values_of(const Rows& rows, const std::vector<double>& at) {
  VectorXd out(rows.size());
  rows.values(gathered(rows, at), out);
  return out;
}

bool are_alike(const std::vector<std::unique_ptr<const Rows>>& some,
               const std::vector<std::unique_ptr<const Rows>>& others) {
  if (some.size() != others.size()) return false;
  for (std::size_t i = 0; i < some.size(); ++i) {
    if (some[i]->size() != others[i]->size() || some[i]->variables() != others[i]->variables()) {
      return false;
    }
  }
  return true;
}

/// How far the bound moves that a multiplier of this sign belongs to: above 0 the upper one.
double moved(const Bounds& from, const Bounds& to, double multiplier) {
  const double by = multiplier > 0.0 ? to.upper - from.upper : to.lower - from.lower;
  return std::isfinite(by) ? by : 0.0;  // of no bound: its multiplier is the barrier's rest
}

/// Adds factors^T Jacobian to a vector by unknown.
void add_slopes(const Rows& rows, const VectorXd& factors, const std::vector<double>& at,
                VectorXd& sum) {
  MatrixXd jacobian(rows.size(), rows.width());
  rows.slopes(gathered(rows, at), jacobian);
  const VectorXd slopes = jacobian.transpose() * factors;
  for (Eigen::Index i = 0; i < rows.width(); ++i) {
    sum[rows.variables()[static_cast<std::size_t>(i)]] += slopes[i];
  }
}

}  // namespace

std::optional<double> first_order_change(const Program& program, const NonlinearSolution& solution,
                                         const Program& changed) {
  const std::vector<double>& at = solution.values;
  if (static_cast<int>(solution.multipliers.size()) != program.row_count() ||
      program.variable_count() != changed.variable_count() ||
      !are_alike(program.rows(), changed.rows()) || !are_alike(program.costs(), changed.costs())) {
    return std::nullopt;
  }
  double change = 0.0;
  // Slopes of the Lagrangian by unknown: at an optimum the multipliers of their bounds, negated.
  VectorXd slopes = VectorXd::Zero(program.variable_count());
  for (std::size_t i = 0; i < program.costs().size(); ++i) {
    const Rows& cost = *program.costs()[i];
    change += (values_of(*changed.costs()[i], at) - values_of(cost, at)).sum();
    add_slopes(cost, VectorXd::Ones(cost.size()), at, slopes);
  }
  std::size_t next = 0;
  for (std::size_t i = 0; i < program.rows().size(); ++i) {
    const Rows& rows = *program.rows()[i];
    const VectorXd moves = values_of(*changed.rows()[i], at) - values_of(rows, at);
    VectorXd multipliers(rows.size());
    for (Eigen::Index k = 0; k < rows.size(); ++k) {
      const auto row = static_cast<std::size_t>(k);
      multipliers[k] = solution.multipliers[next++];
      change +=
          multipliers[k] *
          (moves[k] - moved(rows.bounds()[row], changed.rows()[i]->bounds()[row], multipliers[k]));
    }
    add_slopes(rows, multipliers, at, slopes);
  }
  for (Eigen::Index i = 0; i < slopes.size(); ++i) {
    const auto unknown = static_cast<std::size_t>(i);
    change += slopes[i] * moved(program.bounds()[unknown], changed.bounds()[unknown], -slopes[i]);
  }
  if (!std::isfinite(change)) return std::nullopt;
  return change;
}

}  // namespace torquewright::optimization
