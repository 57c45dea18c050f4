// SPDX-License-Identifier: Apache-2.0
#include "learning/formulas/advantages.hpp"

namespace torquewright::learning {

void advantages_of(const Stretch& stretch, double discount, double lambda,
                   Eigen::Ref<Eigen::VectorXd> advantages) {
  double later = 0.0;
  for (Eigen::Index t = stretch.rewards.size() - 1; t >= 0; --t) {
    const double surprise =
        stretch.rewards(t) + discount * stretch.next_values(t) - stretch.values(t);
    const bool goes_on = stretch.goes_on[static_cast<std::size_t>(t)] != 0;
    later = surprise + (goes_on ? discount * lambda * later : 0.0);
    advantages(t) = later;
  }
}

}  // namespace torquewright::learning
