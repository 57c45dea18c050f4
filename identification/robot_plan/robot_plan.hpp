// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "identification/robot_plan/motion_room.hpp"
#include "identification/rollout/value_fit.hpp"

namespace torquewright::identification {

struct RobotPlanOptions {
  double duration_s = 40.0;          ///< Of all runs together.
  double position_noise_rad = 5e-4;  ///< Standard deviation of the encoders' white noise.
  MotionLimits limits;
  std::vector<std::string> runs = {"1", "2", "3", "4"};
  std::size_t candidates = 4;  ///< Motions that are drawn for each run.
  std::uint64_t seed = 1;
};

/// A value of a robot, and how well a log of the planned motion would tell it.
struct PlannedValue {
  FittedValue by_plan;   ///< At its stated value, with the standard error to be expected.
  FittedValue by_sweep;  ///< The same of one sweep of frequencies in every run, as long.
  /// Another value that may stand for it: their errors are correlated beyond 0.9.
  std::optional<FreeValue> stands_for_it;
};

struct RobotPlan {
  std::vector<CommandedMotion> motions;  ///< A run each.
  std::vector<PlannedValue> values;
  MotionRoom room;        ///< The least of all runs.
  std::size_t tried = 0;  ///< Motions.
  bool tells_all() const;
};

/// Plans what a robot's joints are to be told so that a log of their positions tells rotor,
/// friction, encoder, body and, where it is to be found, controller of every joint: run by run the
/// one of drawn motions that adds most to the determinant of the values' information (of all joints
/// at once, by simulation under their own loops; docs/logs.md).
/// Every motion keeps within joint limits, speeds, the drives' regions, and clear of the robot's
/// own bodies and the ground. `centre_rad`: where joints begin and end, in the rig's order. The
/// same question gives the same answer. Throws io::SpecError where the robot cannot move about
/// there.
RobotPlan plan_robot(const RobotModel& stated, const hopper::Robot& robot,
                     const std::vector<double>& centre_rad, const RobotPlanOptions& options,
                     const std::function<void(double share)>& on_progress = {});

}  // namespace torquewright::identification
