// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimization/nonlinear/program.hpp"

namespace torquewright::hopper {

/// One value y and its rate r over one interval, h = share T long: the integral of the parabola
/// through the rates at its ends and its middle. Variables: y0, y_mid, y1, r0, r_mid, r1, T.
/// Rows: y1 - y0 - h/6 (r0 + 4 r_mid + r1), y_mid - (y0 + y1)/2 - h/8 (r0 - r1).
/// docs/derivations/collocation.md eqs. (1), (2).
class HermiteSimpson final : public optimization::Rows {
 public:
  /// Makes the two rows of one interval, `share` of the phase's duration long; `scale` is that of
  /// the value.
  HermiteSimpson(std::string name, std::vector<int> variables, double share, double scale);

  void values(const VectorIn& x, VectorOut rows) const override;
  void slopes(const VectorIn& x, MatrixOut jacobian) const override;
  void curvatures(const VectorIn& x, const VectorIn& multipliers, MatrixOut hessian) const override;

 private:
  double share_;
};

}  // namespace torquewright::hopper
