// SPDX-License-Identifier: Apache-2.0
#include "identification/rollout/rollout.hpp"

#include <algorithm>
#include <cmath>

#include "identification/selection/run_results.hpp"
#include "identification/simulated/rig_plant.hpp"
#include "simulation/run/simulate.hpp"

namespace torquewright::identification {
namespace {

constexpr double kLongestStep_s = 1e-3;
/// Of a position that no joint comes to; what is beyond grew without bound.
constexpr double kBeyond_rad = 1e3;
constexpr std::size_t kDrawnShares = 300;

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

/// By the rig's joints; empty where one of them grows without bound.
std::vector<std::vector<double>> errors_rad(const RobotModel& model, const std::vector<Limb>& limbs,
                                            const Run& run, const Window& window) {
  std::vector<std::vector<double>> all(model.drives.size());
  for (const Limb& limb : limbs) {
    auto of_limb = limb_errors_rad(model, limb, run, window, kLongestStep_s);
    if (of_limb.empty()) return {};
    for (std::size_t i = 0; i < limb.joints.size(); ++i) {
      all[limb.joints[i]] = std::move(of_limb[i]);
    }
  }
  return all;
}

void add(const std::vector<std::vector<double>>& off_rad, std::size_t settled, Sums& sums) {
  sums.by_joint.resize(off_rad.size(), 0.0);
  for (std::size_t joint = 0; joint < off_rad.size(); ++joint) {
    for (std::size_t i = settled; i < off_rad[joint].size(); ++i) {
      sums.by_joint[joint] += off_rad[joint][i] * off_rad[joint][i];
    }
  }
  sums.samples += static_cast<double>(off_rad.front().size() - settled);
}

/// Samples at a window's beginning that do not count; all of a short one do.
std::size_t settled_after(const Run& run, const Window& window, double settling_s) {
  const double begin_s = run.time_s[window.first];
  if (run.time_s[window.last] - begin_s < 2.0 * settling_s) return 0;
  std::size_t sample = window.first;
  while (run.time_s[sample] - begin_s < settling_s) ++sample;
  return sample - window.first;
}

RolloutTrace trace_of(const Run& run, const Window& window, bool is_held_out,
                      std::vector<std::vector<double>> off_rad) {
  RolloutTrace trace{run.name, is_held_out, {}};
  for (std::vector<double>& of_joint : off_rad) {
    const auto begin = run.time_s.begin() + static_cast<std::ptrdiff_t>(window.first);
    const Curve whole{{begin, begin + static_cast<std::ptrdiff_t>(of_joint.size())},
                      std::move(of_joint)};
    trace.error_rad.push_back(thinned(whole, kDrawnShares));
  }
  return trace;
}

}  // namespace

bool can_roll_out(const Rig& rig) {
  return rig.load.type == LoadType::kRobot && !rig.controllers.empty() &&
         std::all_of(rig.controllers.begin(), rig.controllers.end(),
                     [](const auto& law) { return law.has_value(); });
}

std::vector<std::vector<double>> limb_errors_rad(const RobotModel& model, const Limb& limb,
                                                 const Run& run, const Window& window,
                                                 double longest_step_s) {
  const std::unique_ptr<simulation::Plant> plant = plant_of(limb.load);
  simulation::SimulationOptions options;
  options.longest_step_s = longest_step_s;
  options.traces_motion_only = true;
  std::vector<const actuator::Actuator*> drives;
  for (const std::size_t joint : limb.joints) drives.push_back(&model.drives[joint]);
  const simulation::SimulatedRun simulated =
      simulation::simulate(*plant, drives, excitation_of(model, limb, run, window),
                           start_of(model, limb, run, window), options);
  if (!simulated.is_finite) return {};
  std::vector<std::vector<double>> off_rad;
  for (std::size_t i = 0; i < limb.joints.size(); ++i) {
    const std::size_t joint = limb.joints[i];
    const std::vector<double>& was_rad = run.joints[joint][Quantity::kOutputPosition];
    std::vector<double>& off = off_rad.emplace_back(simulated.joints[i].position_rad);
    for (std::size_t sample = 0; sample < off.size(); ++sample) {
      off[sample] -= model.offset_rad[joint] + was_rad[window.first + sample];
      if (!(std::abs(off[sample]) < kBeyond_rad)) return {};
    }
  }
  return off_rad;
}

Rollout roll_out(const Log& log, const RobotModel& model, const RolloutPlan& plan,
                 const std::function<void(double share)>& on_progress) {
  const std::vector<Limb> limbs = limbs_of(model.load);
  const std::vector<Window> windows = spread(windows_of(log, plan.window_s), plan.most_windows);
  Rollout rollout{plan.window_s, {}, {}, {}};
  Sums train, holdout;
  for (std::size_t k = 0; k < windows.size(); ++k) {
    const Run& run = log.runs[windows[k].run];
    const bool held_out = is_held_out(log, run.name);
    Sums& sums = held_out ? holdout : train;
    ++sums.windows;
    auto off_rad = errors_rad(model, limbs, run, windows[k]);
    if (off_rad.empty()) {
      ++sums.diverged;
    } else {
      add(off_rad, settled_after(run, windows[k], plan.settling_s), sums);
      if (plan.keeps_traces) {
        rollout.traces.push_back(trace_of(run, windows[k], held_out, std::move(off_rad)));
      }
    }
    if (on_progress) on_progress(static_cast<double>(k + 1) / static_cast<double>(windows.size()));
  }
  rollout.train = train.error();
  rollout.holdout = holdout.error();
  return rollout;
}

}  // namespace torquewright::identification
