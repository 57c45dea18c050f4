// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/plane/hermite_simpson.hpp"

#include <utility>

namespace torquewright::hopper {
namespace {

enum Variable : Eigen::Index { kY0, kYMid, kY1, kR0, kRMid, kR1, kDuration };

}  // namespace

HermiteSimpson::HermiteSimpson(std::string name, std::vector<int> variables, double share,
                               double scale)
    : Rows(std::move(name), std::move(variables), {{0.0, 0.0}, {0.0, 0.0}}, {scale, scale}),
      share_(share) {}

void HermiteSimpson::values(const VectorIn& x, VectorOut rows) const {
  const double h = share_ * x[kDuration];
  rows[0] = x[kY1] - x[kY0] - h / 6.0 * (x[kR0] + 4.0 * x[kRMid] + x[kR1]);
  rows[1] = x[kYMid] - 0.5 * (x[kY0] + x[kY1]) - h / 8.0 * (x[kR0] - x[kR1]);
}

void HermiteSimpson::slopes(const VectorIn& x, MatrixOut jacobian) const {
  const double h = share_ * x[kDuration];
  jacobian.setZero();
  jacobian(0, kY1) = 1.0;
  jacobian(0, kY0) = -1.0;
  jacobian(0, kR0) = jacobian(0, kR1) = -h / 6.0;
  jacobian(0, kRMid) = -4.0 * h / 6.0;
  jacobian(0, kDuration) = -share_ / 6.0 * (x[kR0] + 4.0 * x[kRMid] + x[kR1]);
  jacobian(1, kYMid) = 1.0;
  jacobian(1, kY0) = jacobian(1, kY1) = -0.5;
  jacobian(1, kR0) = -h / 8.0;
  jacobian(1, kR1) = h / 8.0;
  jacobian(1, kDuration) = -share_ / 8.0 * (x[kR0] - x[kR1]);
}

void HermiteSimpson::curvatures(const VectorIn&, const VectorIn& multipliers,
                                MatrixOut hessian) const {
  hessian.setZero();
  const auto set = [&](Eigen::Index rate, double value) {
    hessian(rate, kDuration) = hessian(kDuration, rate) = value;
  };
  const double simpson = -share_ / 6.0 * multipliers[0];
  const double hermite = -share_ / 8.0 * multipliers[1];
  set(kR0, simpson + hermite);
  set(kRMid, 4.0 * simpson);
  set(kR1, simpson - hermite);
}

}  // namespace torquewright::hopper
