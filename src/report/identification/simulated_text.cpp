// SPDX-License-Identifier: Apache-2.0
#include "src/report/identification/simulated_text.hpp"

#include <fmt/format.h>

namespace torquewright::report {
namespace {

using identification::Rollout;
using identification::RolloutError;
using identification::SimulatedErrors;

std::string milliradians(double error_rad) { return fmt::format("{:.3g}", 1e3 * error_rad); }

/// "12.3 -> 4.5", or the first alone where nothing was refined.
std::string change(double before_rad, const double* after_rad) {
  if (after_rad == nullptr) return milliradians(before_rad);
  return fmt::format("{} -> {}", milliradians(before_rad), milliradians(*after_rad));
}

/// The runs that no fit saw, or the fitted ones where none was held out.
const RolloutError& judged(const Rollout& rollout) {
  return rollout.holdout.windows > 0 ? rollout.holdout : rollout.train;
}

std::string diverged_text(const SimulatedErrors& errors) {
  std::size_t diverged = 0, windows = 0;
  for (const std::vector<Rollout>* all : {&errors.before, &errors.after}) {
    for (const Rollout& rollout : *all) {
      for (const RolloutError* error : {&rollout.train, &rollout.holdout}) {
        diverged += error->diverged;
        windows += error->windows;
      }
    }
  }
  if (diverged == 0) return "";
  return fmt::format(
      "             {} of {} windows are left out: the robot under the stated law of "
      "its controllers is not stable there\n",
      diverged, windows);
}

}  // namespace

std::string simulated_text(const SimulatedErrors& errors) {
  const bool is_held_out = errors.before.front().holdout.windows > 0;
  std::string text =
      fmt::format("simulated      the whole robot under its own controllers, mrad rms on {} runs\n",
                  is_held_out ? "held-out" : "fitted");
  for (std::size_t length = 0; length < errors.before.size(); ++length) {
    const RolloutError& before = judged(errors.before[length]);
    if (before.by_joint_rad.empty()) continue;
    const double* after = errors.after.empty() ? nullptr : &judged(errors.after[length]).all_rad;
    text += fmt::format("  windows of {:g} s{:>10}  {}\n", errors.before[length].window_s, "",
                        change(before.all_rad, after));
  }
  const std::size_t leading = identification::kLeadingWindow;
  const RolloutError& before = judged(errors.before[leading]);
  for (std::size_t joint = 0; joint < before.by_joint_rad.size(); ++joint) {
    const double* after = errors.after.empty() || judged(errors.after[leading]).by_joint_rad.empty()
                              ? nullptr
                              : &judged(errors.after[leading]).by_joint_rad[joint];
    text += fmt::format("    {:24} {}\n", errors.joints[joint],
                        change(before.by_joint_rad[joint], after));
  }
  return text + diverged_text(errors);
}

}  // namespace torquewright::report
