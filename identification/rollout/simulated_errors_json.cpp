// SPDX-License-Identifier: Apache-2.0
#include "identification/rollout/simulated_errors_json.hpp"

#include <nlohmann/json.hpp>

namespace torquewright::identification {
namespace {

using nlohmann::ordered_json;

ordered_json rms_or_null(const RolloutError& error, std::size_t joint) {
  if (joint >= error.by_joint_rad.size()) return nullptr;
  return error.by_joint_rad[joint];
}

ordered_json rms_or_null(const RolloutError& error) {
  if (error.by_joint_rad.empty()) return nullptr;
  return error.all_rad;
}

}  // namespace

ordered_json errors_json(const Rollout& rollout) {
  return {{"train_rms", rms_or_null(rollout.train)},
          {"holdout_rms", rms_or_null(rollout.holdout)},
          {"diverged", rollout.train.diverged + rollout.holdout.diverged}};
}

ordered_json simulated_json(const SimulatedErrors& errors) {
  const bool is_refined = errors.is_refined;
  ordered_json simulated{{"unit", "rad"}, {"windows_s", kWindows_s}};
  simulated["before"] = errors_json(errors.before.whole);
  if (is_refined) simulated["after"] = errors_json(errors.after.whole);
  simulated["by_joint"] = ordered_json::array();
  for (std::size_t joint = 0; joint < errors.joints.size(); ++joint) {
    ordered_json entry{{"joint", errors.joints[joint]},
                       {"before", rms_or_null(judged(errors.before.whole), joint)}};
    if (is_refined) entry["after"] = rms_or_null(judged(errors.after.whole), joint);
    simulated["by_joint"].push_back(std::move(entry));
  }
  simulated["windows"] = ordered_json::array();
  for (std::size_t length = 0; length < kWindows_s.size(); ++length) {
    ordered_json entry{{"window_s", kWindows_s[length]},
                       {"before", errors_json(errors.before.windows[length])}};
    if (is_refined) entry["after"] = errors_json(errors.after.windows[length]);
    simulated["windows"].push_back(std::move(entry));
  }
  return simulated;
}

}  // namespace torquewright::identification
