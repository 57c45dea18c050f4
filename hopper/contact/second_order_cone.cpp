// SPDX-License-Identifier: Apache-2.0
#include "hopper/contact/second_order_cone.hpp"

#include <cmath>

namespace torquewright::hopper {

double cone_determinant(const ConeVector& x) {
  const double t = x.head<2>().norm();
  return (x.z() - t) * (x.z() + t);  // loses no digits near the edge
}

ConeVector cone_product(const ConeVector& x, const ConeVector& y) {
  ConeVector product;
  product << x.z() * y.head<2>() + y.z() * x.head<2>(), x.dot(y);
  return product;
}

ConeVector cone_quotient(const ConeVector& b, const ConeVector& x) {
  const double along = x.head<2>().dot(b.head<2>());
  const double n = (x.z() * b.z() - along) / cone_determinant(x);
  ConeVector y;
  y << (b.head<2>() - n * x.head<2>()) / x.z(), n;
  return y;
}

Eigen::Matrix3d nesterov_todd(const ConeVector& x, const ConeVector& z) {
  const double x_size = std::sqrt(cone_determinant(x));
  const double z_size = std::sqrt(cone_determinant(z));
  const ConeVector x_unit = x / x_size;
  ConeVector z_mirrored = z / z_size;
  const double gamma = std::sqrt(0.5 * (1.0 + x_unit.dot(z_mirrored)));
  z_mirrored.head<2>() *= -1.0;
  const ConeVector w = (x_unit + z_mirrored) / (2.0 * gamma);
  const Eigen::Vector2d t = w.head<2>();
  Eigen::Matrix3d matrix;
  matrix << Eigen::Matrix2d::Identity() + t * t.transpose() / (1.0 + w.z()), t, t.transpose(),
      w.z();
  return std::sqrt(x_size / z_size) * matrix;
}

double share_to_boundary(const ConeVector& x, const ConeVector& step) {
  // n + a dn = |t + a dt|: c + 2 b a + a^2 q = 0 with c > 0.
  const double q = step.z() * step.z() - step.head<2>().squaredNorm();
  const double b = x.z() * step.z() - x.head<2>().dot(step.head<2>());
  const double c = cone_determinant(x);
  const double root = b * b - q * c;
  double share = 1.0;
  if (root >= 0.0) {
    // The least positive root, in the form that does not cancel.
    const double sum = b + std::copysign(std::sqrt(root), b);
    const double candidates[] = {q != 0.0 ? -sum / q : -1.0, sum != 0.0 ? -c / sum : -1.0};
    for (const double candidate : candidates) {
      if (candidate > 0.0 && candidate < share) share = candidate;
    }
  }
  if (step.z() < 0.0) share = std::min(share, -x.z() / step.z());
  return share;
}

}  // namespace torquewright::hopper
