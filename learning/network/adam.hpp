// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace torquewright::learning {

/// Adam (Kingma and Ba 2015) with its published constants: for a gradient g at step t
///
///   m = b1 m + (1 - b1) g,   v = b2 v + (1 - b2) g^2,
///   parameters -= rate (m / (1 - b1^t)) / (sqrt(v / (1 - b2^t)) + e).
template <typename Scalar>
struct Adam {
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  explicit Adam(Eigen::Index parameters)
      : mean(Vector::Zero(parameters)), square(Vector::Zero(parameters)) {}

  /// One step down the gradient, which is of the size of the parameters.
  void step(const Vector& gradient, double rate, Vector& parameters);

  Vector mean;
  Vector square;
  std::int64_t steps = 0;
};

extern template struct Adam<float>;
extern template struct Adam<double>;

}  // namespace torquewright::learning
