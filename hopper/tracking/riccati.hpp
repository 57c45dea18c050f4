// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

namespace torquewright::hopper {

/// One step x+ = A x + B u at the cost x^T Q x + u^T R u; R positive definite, Q not negative.
struct LinearStep {
  Eigen::MatrixXd A;  ///< (m+ x m): the state may change its size in a step.
  Eigen::MatrixXd B;  ///< (m+ x k)
  Eigen::MatrixXd Q;  ///< (m x m)
  Eigen::MatrixXd R;  ///< (k x k)
};

struct RiccatiStep {
  Eigen::MatrixXd cost;  ///< (m x m): x^T P x is the least cost of all that follows.
  Eigen::MatrixXd gain;  ///< (k x m): the best input is u = -K x.
};

/// Takes one step backwards from the cost after it (m+ x m+); docs/derivations/tracking.md eq.
/// (13). Numbers that overflow stay so.
RiccatiStep riccati_step(const LinearStep& step, const Eigen::MatrixXd& cost_after);

/// What constants w (p x 1) change of a step and of what follows: x+ = A x + B u + D w.
struct ConstantStep {
  Eigen::MatrixXd cost;  ///< (m x p): 2 x^T cost w is the part of the least cost that knows both.
  Eigen::MatrixXd gain;  ///< (k x p): the best input is u = -K x - gain w.
};

/// Takes the step backwards beside riccati_step(), whose result for it is `regulated`, from the
/// costs after it (m+ x m+) and (m+ x p); docs/derivations/tracking.md eq. (17).
ConstantStep constant_step(const LinearStep& step, const Eigen::MatrixXd& drift,
                           const RiccatiStep& regulated, const Eigen::MatrixXd& cost_after,
                           const Eigen::MatrixXd& constant_cost_after);

/// Returns the same of all steps without end, `regulated` being what steady_riccati() found.
ConstantStep steady_constant(const LinearStep& step, const Eigen::MatrixXd& drift,
                             const RiccatiStep& regulated);

/// Returns the cost of all steps without end, A square; by doubling (Anderson 1978; eq. (15)): k
/// doublings are 2^k steps. None where 60 of them do not settle it: no u holds the state, or
/// nothing in Q asks for it.
std::optional<RiccatiStep> steady_riccati(const LinearStep& step);

}  // namespace torquewright::hopper
