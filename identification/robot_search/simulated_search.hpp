// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "identification/robot/robot_study.hpp"

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

/// Searches limb by limb for effects of the drives that the simulation of the robot under its own
/// loops lacks: each candidate's share of what is left, beside all values of the limb, by slopes;
/// then fits of the best, and of what the balance of torques named, by output error. An effect is
/// found that follows the training runs better by 5 standard errors, beside all values, and the
/// held-out runs too. The study is fitted again with what was found; where that follows no better
/// than the study did, nothing is said. `asks`: whether an effect of a
/// name may be named.
SimulatedSearch search_by_simulation(const Log& log, const RobotModel& stated,
                                     const NamedByJoint& named,
                                     const std::vector<std::vector<std::size_t>>& alike,
                                     const std::function<bool(const std::string&)>& asks,
                                     RobotStudy& study,
                                     const std::function<void(double share)>& on_progress = {});

}  // namespace torquewright::identification
