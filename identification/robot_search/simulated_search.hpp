// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "identification/robot/robot_study.hpp"
#include "identification/robot_search/simulated_effect.hpp"

namespace torquewright::identification {

/// Searches limb by limb for effects of the drives that the simulation of the robot under its own
/// loops lacks: each candidate's share of what is left, beside all values of the limb, by slopes;
/// then fits of the best, and of what the balances of torques named, by output error. An effect is
/// found that follows the training runs better by 5 standard errors, beside all values, and leaves
/// less of its joint's error on the held-out runs: less than half where no balance named it. The
/// study is fitted again with what was found; where that follows no better than the study did,
/// nothing is said. `asks`: whether an effect of a name may be named.
SimulatedSearch search_by_simulation(const Log& log, const RobotModel& stated,
                                     const NamedByJoint& named,
                                     const std::vector<std::vector<std::size_t>>& alike,
                                     const std::function<bool(const std::string&)>& asks,
                                     RobotStudy& study,
                                     const std::function<void(double share)>& on_progress = {});

}  // namespace torquewright::identification
