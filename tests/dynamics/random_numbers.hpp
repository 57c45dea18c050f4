// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "tests/oracles/dice.hpp"

namespace torquewright::test {

/// Uniform in [least, most], the same with every standard library.
inline double uniform(oracles::Dice& dice, double least, double most) {
  constexpr std::int64_t kSteps = std::int64_t{1} << 40;
  const double share = static_cast<double>(dice.between(0, kSteps)) / static_cast<double>(kSteps);
  return least + share * (most - least);
}

inline Eigen::VectorXd uniform_vector(oracles::Dice& dice, Eigen::Index size, double greatest) {
  Eigen::VectorXd drawn(size);
  for (double& element : drawn) element = uniform(dice, -greatest, greatest);
  return drawn;
}

/// Largest difference of two vectors or matrices relative to the largest element (at least 1).
template <typename A, typename B>
double difference(const A& a, const B& b) {
  const double scale = std::max(1.0, b.cwiseAbs().maxCoeff());
  return (a - b).cwiseAbs().maxCoeff() / scale;
}

}  // namespace torquewright::test
