// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/joint_barriers.hpp"

#include <cmath>

#include "hopper/training/rewards/barrier.hpp"

namespace torquewright::hopper {

double joint_barriers(const Eigen::VectorXd& values, const RewardNumbers& numbers) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double below = values[i] - numbers.joint_least[i];
    const double above = numbers.joint_greatest[i] - values[i];
    double both = 0.0;
    if (std::isfinite(below)) both += relaxed_log(below, numbers.softness);
    if (std::isfinite(above)) both += relaxed_log(above, numbers.softness);
    sum += numbers.joint_weight[i] * both;
  }
  return sum;
}

}  // namespace torquewright::hopper
