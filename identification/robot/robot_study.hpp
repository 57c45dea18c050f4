// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "identification/robot/alike.hpp"
#include "identification/robot/base_motion.hpp"
#include "identification/robot/load_errors.hpp"
#include "identification/robot/trade_offs.hpp"
#include "identification/rollout/value_fit.hpp"

namespace torquewright::identification {

/// What a robot's own motion says of its values: those of its drives and of what they move.
struct RobotStudy {
  ValueFit fit;
  /// By joint, whether its dry friction varies with its angle.
  std::vector<bool> varies;
  std::vector<AlikeNumber> alike;
  LoadErrors load;
  std::vector<TradeOff> trade_offs;
  BaseMotion base;
};

/// Fits rotor, friction, encoder and bodies of every joint by output error (fit_values) on the runs
/// that are not held out, and what is to be found of their controllers. Dry friction may vary with
/// the angle at any joint; where it does not do so by 5 standard errors it is taken to be constant,
/// and the rest is fitted again. `alike`: indices of joints with the same hardware. The base's
/// attitude is fitted where the rig calls it uncertain.
RobotStudy study_robot(const Rig& rig, const Log& log, const RobotModel& stated,
                       const std::vector<std::vector<std::size_t>>& alike,
                       const std::function<void(double share)>& on_progress = {});

/// What follows from a fit's values: sisters that differ, bodies, the base, what stands for what.
void tell_of(const Log& log, const RobotModel& stated,
             const std::vector<std::vector<std::size_t>>& alike, RobotStudy& study);

}  // namespace torquewright::identification
