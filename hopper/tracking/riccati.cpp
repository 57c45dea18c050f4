// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/riccati.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace torquewright::hopper {
namespace {

using Eigen::MatrixXd;

void make_symmetric(MatrixXd& matrix) { matrix = (0.5 * (matrix + matrix.transpose())).eval(); }

}  // namespace

RiccatiStep riccati_step(const LinearStep& step, const MatrixXd& cost_after) {
  const MatrixXd weighted = step.B.transpose() * cost_after;
  RiccatiStep out;
  out.gain = (step.R + weighted * step.B).llt().solve(weighted * step.A);
  // As a sum of squares, so that rounding makes no cost negative.
  const MatrixXd closed = step.A - step.B * out.gain;
  out.cost =
      step.Q + out.gain.transpose() * step.R * out.gain + closed.transpose() * cost_after * closed;
  make_symmetric(out.cost);
  return out;
}

ConstantStep constant_step(const LinearStep& step, const MatrixXd& drift,
                           const RiccatiStep& regulated, const MatrixXd& cost_after,
                           const MatrixXd& constant_cost_after) {
  if (drift.cols() == 0) return {MatrixXd(step.A.cols(), 0), MatrixXd(step.B.cols(), 0)};
  const MatrixXd pushed = cost_after * drift + constant_cost_after;
  const MatrixXd weight = step.R + step.B.transpose() * cost_after * step.B;
  ConstantStep out;
  out.gain = weight.llt().solve(step.B.transpose() * pushed);
  out.cost = (step.A - step.B * regulated.gain).transpose() * pushed;
  return out;
}

ConstantStep steady_constant(const LinearStep& step, const MatrixXd& drift,
                             const RiccatiStep& regulated) {
  if (drift.cols() == 0) return {MatrixXd(step.A.cols(), 0), MatrixXd(step.B.cols(), 0)};
  const MatrixXd closed = (step.A - step.B * regulated.gain).transpose();
  const MatrixXd still = MatrixXd::Identity(closed.rows(), closed.cols()) - closed;
  const MatrixXd cost = still.partialPivLu().solve(closed * (regulated.cost * drift));
  return constant_step(step, drift, regulated, regulated.cost, cost);
}

std::optional<RiccatiStep> steady_riccati(const LinearStep& step) {
  constexpr int kMostDoublings = 60;
  constexpr double kSettled = 1e-13;
  const MatrixXd identity = MatrixXd::Identity(step.A.rows(), step.A.rows());
  MatrixXd A = step.A;
  MatrixXd G = step.B * step.R.llt().solve(step.B.transpose());
  MatrixXd H = step.Q;
  for (int i = 0; i < kMostDoublings; ++i) {
    const Eigen::PartialPivLU<MatrixXd> solver(identity + G * H);
    const MatrixXd WA = solver.solve(A);
    MatrixXd more = A.transpose() * H * WA;
    G = (G + A * solver.solve(G) * A.transpose()).eval();
    A = (A * WA).eval();
    make_symmetric(more);
    make_symmetric(G);
    H += more;
    if (!H.allFinite() || !A.allFinite()) return std::nullopt;
    // Not by norms: their squares overflow before the numbers do.
    if (more.cwiseAbs().maxCoeff() > kSettled * H.cwiseAbs().maxCoeff()) continue;
    RiccatiStep steady = riccati_step(step, H);
    if (!steady.gain.allFinite()) return std::nullopt;
    return steady;
  }
  return std::nullopt;
}

}  // namespace torquewright::hopper
