// SPDX-License-Identifier: Apache-2.0
#include "identification/rollout/simulated_errors.hpp"

namespace torquewright::identification {
namespace {

/// Of each length, evenly over the log.
constexpr std::size_t kMostShort = 60, kMostWhole = 12;

}  // namespace

RobotErrors robot_errors(const Log& log, const RobotModel& model,
                         const std::function<void(double share)>& on_progress) {
  RobotErrors errors;
  const auto lengths = static_cast<double>(kWindows_s.size() + 1);
  double done = 0.0;
  const auto run = [&](const RolloutPlan& plan) {
    Rollout rollout = roll_out(log, model, plan, [&](double share) {
      if (on_progress) on_progress((done + share) / lengths);
    });
    ++done;
    return rollout;
  };
  for (const double window_s : kWindows_s) {
    errors.windows.push_back(run({window_s, 0.0, kMostShort, false}));
  }
  errors.whole = run({kLongestWhole_s, kSettling_s, kMostWhole, true});
  return errors;
}

const RolloutError& judged(const Rollout& rollout) {
  return rollout.holdout.windows > 0 ? rollout.holdout : rollout.train;
}

}  // namespace torquewright::identification
