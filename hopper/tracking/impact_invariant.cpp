// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/impact_invariant.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>
#include <stdexcept>
#include <string>

// Equations: docs/derivations/impact_invariance.md.
namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Rows that depend on each other leave, of the largest pivot, some 1e-13 of round-off; the least
/// effect of an impulse that is one is above 1e-4 of the largest.
constexpr double kDependent = 1e-9;

void require_fit(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(std::string("impact: ") + what);
}

/// Least squares, the least solution where columns depend on each other.
VectorXd least_solution(const MatrixXd& matrix, const VectorXd& right_side) {
  if (matrix.size() == 0) return VectorXd::Zero(matrix.cols());
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> parts;
  parts.setThreshold(kDependent);
  return parts.compute(matrix).solve(right_side);
}

/// Columns that span what the matrix takes to zero, orthonormal.
MatrixXd kernel_of(const MatrixXd& matrix) {
  Eigen::ColPivHouseholderQR<MatrixXd> parts;
  parts.setThreshold(kDependent);
  parts.compute(matrix.transpose());
  const MatrixXd basis = parts.householderQ();
  return basis.rightCols(matrix.cols() - parts.rank());
}

/// U of G = U^T U: its norm of U e is e's in the metric G, eq. (7).
MatrixXd root_of(const MatrixXd& metric) {
  const Eigen::LLT<MatrixXd> factor(metric);
  require_fit(factor.info() == Eigen::Success, "an impact's metric is positive definite");
  return factor.matrixU();
}

/// The impulses whose change of the outputs' rates is nearest to the error, eqs. (5) and (6): those
/// that the held rows ask for, and of the rest the best.
VectorXd nearest_impulses(const ImpactMap& map, const MatrixXd& change, const VectorXd& error) {
  if (map.held_change.rows() == 0) return least_solution(change, error);
  const VectorXd asked = least_solution(map.held_change, -map.held_rate);
  const MatrixXd free = kernel_of(map.held_change);
  return asked + free * least_solution(change * free, error - change * asked);
}

}  // namespace

ImpactMap impact_map(const MatrixXd& mass, const MatrixXd& jacobian, const MatrixXd& outputs) {
  return impact_map(mass, jacobian, outputs, MatrixXd::Zero(0, mass.cols()),
                    VectorXd::Zero(mass.cols()));
}

ImpactMap impact_map(const MatrixXd& mass, const MatrixXd& jacobian, const MatrixXd& outputs,
                     const MatrixXd& held, const VectorXd& velocity) {
  require_fit(mass.rows() == mass.cols() && jacobian.cols() == mass.cols() &&
                  outputs.cols() == mass.cols() && held.cols() == mass.cols() &&
                  velocity.size() == mass.cols(),
              "an impact's matrices have a column per velocity");
  const Eigen::LLT<MatrixXd> factor(mass);
  require_fit(factor.info() == Eigen::Success, "an impact's mass matrix is positive definite");
  MatrixXd rows(jacobian.rows() + held.rows(), mass.cols());
  rows << jacobian, held;
  MatrixXd change(mass.cols(), rows.rows());  // B, eq. (2).
  if (rows.rows() > 0) change = factor.solve(rows.transpose());
  const MatrixXd mobility = outputs * factor.solve(outputs.transpose());
  return {outputs * change, mobility.inverse(), held * change, held * velocity};
}

double impact_blend(const ImpactOptions& options, double time_from_impact_s) {
  require_fit(options.blend_s > 0.0, "an impact's blend_s is above 0");
  const double away_s = std::abs(time_from_impact_s);
  if (away_s >= 1.5 * options.window_s) return 0.0;
  return 1.0 / (1.0 + std::exp((away_s - options.window_s) / options.blend_s));  // Eq. (9).
}

VectorXd impact_part(const ImpactMap& map, ImpactMetric metric, const VectorXd& error) {
  const MatrixXd& change = map.output_change;
  require_fit(error.size() == change.rows(), "an error of rates has an entry per output");
  require_fit(map.held_change.rows() == map.held_rate.size() &&
                  (map.held_rate.size() == 0 || map.held_change.cols() == change.cols()),
              "an impact's held rows have a rate each and a column per impulse");
  if (metric == ImpactMetric::kEuclidean) return change * nearest_impulses(map, change, error);
  const MatrixXd root = root_of(map.metric);
  return change * nearest_impulses(map, root * change, root * error);
}

void handle_impact(const ImpactOptions& options, double time_from_impact_s, const ImpactMap& map,
                   Eigen::Ref<VectorXd> error) {
  if (options.handling == ImpactHandling::kDefault) return;
  const double blend = impact_blend(options, time_from_impact_s);
  if (blend == 0.0) return;
  if (options.handling == ImpactHandling::kNoDerivative) {
    error *= 1.0 - blend;
    return;
  }
  error -= blend * impact_part(map, options.metric, error);  // Eq. (8).
}

}  // namespace torquewright::hopper
