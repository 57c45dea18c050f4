// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace torquewright::learning {

/// Steps of one copy one after the other, as one value head sees them. All are (steps x 1).
struct Stretch {
  Eigen::Ref<const Eigen::VectorXd> rewards;
  Eigen::Ref<const Eigen::VectorXd> values;       ///< Of the state that the step began in.
  Eigen::Ref<const Eigen::VectorXd> next_values;  ///< Of the state that it led to; 0 if it ended.
  const std::vector<char>& goes_on;               ///< Not 0: the next step is of the same episode.
};

/// Generalised advantages (Schulman et al. 2016): with d_t = r_t + discount v'_t - v_t
///
///   a_t = d_t + discount lambda a_{t+1} where the episode goes on, d_t where it does not
///
/// and behind the last step nothing.
void advantages_of(const Stretch& stretch, double discount, double lambda,
                   Eigen::Ref<Eigen::VectorXd> advantages);

}  // namespace torquewright::learning
