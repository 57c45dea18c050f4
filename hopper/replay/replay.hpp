// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hopper/check/hopper_check.hpp"
#include "hopper/engines/every_engine.hpp"
#include "hopper/replay/result.hpp"
#include "hopper/replay/run.hpp"
#include "hopper/tracking/every_controller.hpp"
#include "hopper/tracking/reference_clock.hpp"
#include "hopper/trials/randomisation.hpp"
#include "hopper/verdict/goal.hpp"

namespace torquewright::hopper {

struct ReplayOptions {
  const EngineKind* engine = &engines::own;
  const ControllerKind* controller = &controllers::lqr;
  std::shared_ptr<const OperationalTasks> tasks;  ///< Of a controller that has some; null: usual.
  DriveLimits limits = DriveLimits::kMor;
  ImpactOptions impact;
  ClockOptions clock;
  RunOptions run;
  EngineOptions engine_options;
  VerdictRule verdict;
  double load_window_s = 0.01;
  /// Speed that hops are commanded, by which they are then judged, of a controller that follows
  /// one.
  std::optional<double> forward_m_s;
  bool acts_late = false;     ///< Whether some run has a latency.
  bool filters_noise = true;  ///< Whether a filter stands between noisy sensors and controller.
  actuator::OperatingConditions conditions;
};

/// Functions that a caller who waits for a run may give.
struct Watching {
  std::function<bool()> should_stop = {};  ///< Called to ask whether to stop. May be empty.
  /// Called with the share that is done. May be empty.
  std::function<void(double share)> on_progress = {};
};

/// A run and what it came to.
struct ReplayedRun {
  Record record;
  ReplayResult result;
};

/// A run with another step of the engine.
struct SweptStep {
  double step_s = 0.0;
  ReplayResult result;
};

/// The most steps of one run, whose record keeps what the drives did in each: so many take ten to
/// twenty seconds and at most 1 GB. 100 s at the usual step of 0.1 ms.
inline constexpr double kMostReplaySteps = 1e6;

/// Throws io::SpecError, with what shortens it, where a run would have more steps than that.
void require_few_steps(const Motion& motion, const RunOptions& run);

/// What follows no motion: a learned policy, and what it is to do.
struct FreeRun {
  Reference ends;  ///< Begins as the robot does and ends in the attitude that the goal has.
  Goal goal;
  std::unique_ptr<const ReadyController> controller;  ///< Of the same robot.
};

/// A robot and a motion, made ready once for any number of runs: what the controller follows, and
/// its gains.
class Replay {
 public:
  /// `report` is the check of the motion: contacts and torques are its. The robot must outlive the
  /// replay. Throws io::SpecError where the motion cannot be replayed: it has no base, begins with
  /// a contact point below the ground, or its drives cannot work under the conditions; or where the
  /// engine is not there.
  Replay(const Robot& robot, const Motion& motion, const HopperReport& report,
         const ReplayOptions& options);
  /// The same of what follows no motion and is judged by its goal. Throws io::SpecError where its
  /// drives cannot work under the conditions, it would begin below the ground, or the engine is
  /// not there.
  Replay(const Robot& robot, FreeRun run, const ReplayOptions& options);
  ~Replay();

  const Reference& reference() const;
  const ReplayOptions& options() const;

  /// The run as the documents say. May be called by several threads at once.
  ReplayedRun run(const Watching& watching) const;
  /// Runs one randomised trial, which depends on seed and number alone. `randomisation` has passed
  /// require_fits().
  ReplayedRun run_trial(const Randomisation& randomisation, std::uint64_t seed, std::size_t number,
                        const Watching& watching) const;
  /// Runs with other steps of the engine: twice, half, a quarter, as far as the control period
  /// allows.
  std::vector<SweptStep> sweep(const Watching& watching) const;

 private:
  struct Ready;
  std::unique_ptr<const Ready> ready_;
};

}  // namespace torquewright::hopper
