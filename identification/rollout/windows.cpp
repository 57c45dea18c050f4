// SPDX-License-Identifier: Apache-2.0
#include "identification/rollout/windows.hpp"

#include <algorithm>

#include "identification/log/delayed.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kLeastOfWindow = 3;

/// First and last samples between which nothing is masked; the run's ends are not among them.
std::vector<Window> whole_stretches(const Run& run, std::size_t index) {
  std::vector<Window> stretches;
  if (run.time_s.size() < kLeastOfWindow + 2) return stretches;
  const std::size_t end = run.time_s.size() - 1;
  std::size_t first = 1;
  for (std::size_t i = 1; i <= end; ++i) {
    if (i < end && run.masked[i] == 0) continue;
    if (i >= first + kLeastOfWindow) stretches.push_back({index, first, i - 1});
    first = i + 1;
  }
  return stretches;
}

void cut(const Run& run, const Window& stretch, double window_s, std::vector<Window>& windows) {
  for (std::size_t first = stretch.first; first < stretch.last;) {
    const auto begin = run.time_s.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = run.time_s.begin() + static_cast<std::ptrdiff_t>(stretch.last) + 1;
    const auto after = std::lower_bound(begin, end, *begin + window_s);
    const bool is_rest = after == end;
    if (is_rest && first > stretch.first) break;
    const std::size_t last =
        is_rest ? stretch.last : static_cast<std::size_t>(after - run.time_s.begin());
    windows.push_back({stretch.run, first, last});
    first = last;
  }
}

}  // namespace

std::vector<Window> windows_of(const Log& log, double window_s) {
  std::vector<Window> windows;
  for (std::size_t index = 0; index < log.runs.size(); ++index) {
    const Run& run = log.runs[index];
    for (const Window& stretch : whole_stretches(run, index)) {
      cut(run, stretch, window_s, windows);
    }
  }
  return windows;
}

std::vector<Window> spread(const std::vector<Window>& all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<Window> few;
  for (std::size_t k = 0; k < most; ++k) few.push_back(all[k * all.size() / most]);
  return few;
}

bool is_held_out(const Log& log, const std::string& run) {
  return std::find(log.holdout_runs.begin(), log.holdout_runs.end(), run) != log.holdout_runs.end();
}

simulation::Excitation excitation_of(const RobotModel& model, const Limb& limb, const Run& run,
                                     const Window& window) {
  const auto cut_out = [&](const std::vector<double>& values) {
    return std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(window.first),
                               values.begin() + static_cast<std::ptrdiff_t>(window.last) + 1);
  };
  simulation::Excitation excitation;
  excitation.time_s = cut_out(run.time_s);
  for (const std::size_t joint : limb.joints) {
    simulation::JointDrive drive;
    drive.kind = simulation::DriveKind::kPositionLaw;
    const JointController& controller = model.controllers[joint];
    drive.law = controller.law;
    const std::vector<double>& command = run.joints[joint][Quantity::kCommandedPosition];
    drive.value = cut_out(delayed(run.time_s, command, controller.delay_s));
    for (double& each : drive.value) each += model.offset_rad[joint];
    excitation.joints.push_back(std::move(drive));
  }
  return excitation;
}

std::vector<simulation::JointStart> start_of(const RobotModel& model, const Limb& limb,
                                             const Run& run, const Window& window) {
  std::vector<simulation::JointStart> start;
  for (const std::size_t joint : limb.joints) {
    const std::vector<double>& position_rad = run.joints[joint][Quantity::kOutputPosition];
    simulation::JointStart& one = start.emplace_back();
    one.position_rad = position_rad[window.first] + model.offset_rad[joint];
    one.speed_rad_s = (position_rad[window.first + 1] - position_rad[window.first - 1]) /
                      (run.time_s[window.first + 1] - run.time_s[window.first - 1]);
  }
  return start;
}

}  // namespace torquewright::identification
