// SPDX-License-Identifier: Apache-2.0
#include "identification/rollout/rollout.hpp"

#include <algorithm>
#include <cmath>

#include "identification/simulated/rig_plant.hpp"
#include "simulation/run/simulate.hpp"

namespace torquewright::identification {
namespace {

constexpr double kLongestStep_s = 1e-3;
/// Of a position that no joint comes to; what is beyond grew without bound.
constexpr double kBeyond_rad = 1e3;

struct Window {
  std::size_t run = 0, first = 0, last = 0;
};

bool is_whole(const Run& run, std::size_t first, std::size_t last) {
  return std::none_of(run.masked.begin() + static_cast<std::ptrdiff_t>(first),
                      run.masked.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                      [](std::uint8_t each) { return each != 0; });
}

/// One after another through each run; the first sample, whose speed is not known, begins none.
std::vector<Window> windows_of(const Log& log, double window_s) {
  std::vector<Window> windows;
  for (std::size_t index = 0; index < log.runs.size(); ++index) {
    const Run& run = log.runs[index];
    if (run.time_s.size() < 4) continue;
    const std::size_t end = run.time_s.size() - 2;
    for (std::size_t first = 1; first < end;) {
      const double until_s = run.time_s[first] + window_s;
      const auto after = std::lower_bound(run.time_s.begin(), run.time_s.end(), until_s);
      std::size_t last = static_cast<std::size_t>(after - run.time_s.begin());
      const bool is_rest = last > end;
      if (is_rest && first > 1) break;
      last = std::min(last, end);
      if (is_whole(run, first, last)) windows.push_back({index, first, last});
      first = last;
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

simulation::Excitation excitation_of(const Rig& rig, const Run& run, const Window& window) {
  const auto cut = [&](const std::vector<double>& values) {
    return std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(window.first),
                               values.begin() + static_cast<std::ptrdiff_t>(window.last) + 1);
  };
  simulation::Excitation excitation;
  excitation.time_s = cut(run.time_s);
  for (std::size_t joint = 0; joint < rig.joints.size(); ++joint) {
    simulation::JointDrive drive;
    drive.kind = simulation::DriveKind::kPositionLaw;
    drive.law = *rig.controllers[joint];
    drive.value = cut(run.joints[joint][Quantity::kCommandedPosition]);
    excitation.joints.push_back(std::move(drive));
  }
  return excitation;
}

std::vector<simulation::JointStart> start_of(const Rig& rig, const Run& run, const Window& window) {
  std::vector<simulation::JointStart> start(rig.joints.size());
  for (std::size_t joint = 0; joint < start.size(); ++joint) {
    const std::vector<double>& position_rad = run.joints[joint][Quantity::kOutputPosition];
    start[joint].position_rad = position_rad[window.first];
    start[joint].speed_rad_s = (position_rad[window.first + 1] - position_rad[window.first - 1]) /
                               (run.time_s[window.first + 1] - run.time_s[window.first - 1]);
  }
  return start;
}

/// Sums of squares over the samples of windows.
struct Sums {
  std::vector<double> by_joint;
  double samples = 0.0;
  std::size_t windows = 0, diverged = 0;

  RolloutError error() const {
    RolloutError error;
    error.windows = windows;
    error.diverged = diverged;
    if (!(samples > 0.0)) return error;
    double sum = 0.0;
    for (const double each : by_joint) {
      error.by_joint_rad.push_back(std::sqrt(each / samples));
      sum += each;
    }
    error.all_rad = std::sqrt(sum / (samples * static_cast<double>(by_joint.size())));
    return error;
  }
};

void add(const Rig& rig, const Run& run, const Window& window,
         const std::vector<const actuator::Actuator*>& actuators, Sums& sums) {
  sums.by_joint.resize(rig.joints.size(), 0.0);
  const std::unique_ptr<simulation::Plant> plant = plant_of(rig.load);
  simulation::SimulationOptions options;
  options.longest_step_s = kLongestStep_s;
  const simulation::SimulatedRun simulated = simulation::simulate(
      *plant, actuators, excitation_of(rig, run, window), start_of(rig, run, window), options);
  const std::size_t samples = window.last - window.first + 1;
  std::vector<double> squares(rig.joints.size(), 0.0);
  bool is_sound = simulated.is_finite;
  for (std::size_t joint = 0; joint < squares.size() && is_sound; ++joint) {
    const std::vector<double>& is_rad = simulated.joints[joint].position_rad;
    const std::vector<double>& was_rad = run.joints[joint][Quantity::kOutputPosition];
    for (std::size_t i = 0; i < samples; ++i) {
      const double off_rad = is_rad[i] - was_rad[window.first + i];
      is_sound = is_sound && std::abs(off_rad) < kBeyond_rad;
      squares[joint] += off_rad * off_rad;
    }
  }
  ++sums.windows;
  if (!is_sound) {
    ++sums.diverged;
    return;
  }
  for (std::size_t joint = 0; joint < squares.size(); ++joint)
    sums.by_joint[joint] += squares[joint];
  sums.samples += static_cast<double>(samples);
}

bool is_held_out(const Log& log, const std::string& run) {
  return std::find(log.holdout_runs.begin(), log.holdout_runs.end(), run) != log.holdout_runs.end();
}

}  // namespace

bool can_roll_out(const Rig& rig) {
  return rig.load.type == LoadType::kRobot && !rig.controllers.empty() &&
         std::all_of(rig.controllers.begin(), rig.controllers.end(),
                     [](const auto& law) { return law.has_value(); });
}

std::vector<Rollout> roll_out(const Rig& rig, const Log& log,
                              const std::vector<const actuator::Actuator*>& actuators,
                              const std::vector<double>& windows_s, std::size_t most_windows,
                              const std::function<void(double share)>& on_progress) {
  std::vector<Rollout> rollouts;
  for (std::size_t length = 0; length < windows_s.size(); ++length) {
    const std::vector<Window> windows = spread(windows_of(log, windows_s[length]), most_windows);
    Sums train, holdout;
    for (std::size_t k = 0; k < windows.size(); ++k) {
      const Run& run = log.runs[windows[k].run];
      add(rig, run, windows[k], actuators, is_held_out(log, run.name) ? holdout : train);
      if (!on_progress) continue;
      const double done = static_cast<double>(k + 1) / static_cast<double>(windows.size());
      on_progress((static_cast<double>(length) + done) / static_cast<double>(windows_s.size()));
    }
    rollouts.push_back({windows_s[length], train.error(), holdout.error()});
  }
  return rollouts;
}

}  // namespace torquewright::identification
