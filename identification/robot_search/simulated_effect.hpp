// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/rollout/value_fit.hpp"

namespace torquewright::identification {

/// An effect without which the simulated robot does not follow its log.
struct SimulatedEffect {
  std::size_t joint = 0;
  actuator::Effect effect;
  std::vector<FittedValue> values;  ///< Its numbers, in the order of values_of_effect().
  /// By how many standard errors the training runs are followed better with it.
  double sigmas = 0.0;
  std::vector<std::string> rivals;  ///< Effects of the joint that follow them as well.
  /// Root mean squares of the joint on the runs that were held out.
  double before_rad = 0.0, after_rad = 0.0;
};

struct SimulatedSearch {
  std::vector<SimulatedEffect> found;
  /// By joint, names of the effects that were tried.
  std::vector<std::vector<std::string>> tried;
};

/// What the search is told of a joint by its balance of torques.
using NamedByJoint = std::vector<std::vector<actuator::Effect>>;

}  // namespace torquewright::identification
