// SPDX-License-Identifier: Apache-2.0
#include "hopper/replay/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "hopper/replay/charge.hpp"
#include "hopper/replay/fall.hpp"
#include "hopper/replay/free_rotors.hpp"
#include "hopper/replay/left_out.hpp"
#include "hopper/replay/step_limit.hpp"
#include "hopper/trials/sensor_filter.hpp"
#include "hopper/trials/sensor_noise.hpp"
#include "hopper/trials/trial.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/time_text.hpp"

namespace torquewright::hopper {
namespace {

/// What rounding and a file's decimals may leave a foot below the ground.
constexpr double kAllowedDepth_m = 1e-3;

void require_start_above_ground(const Robot& robot, const Motion& motion, double ground_m) {
  dynamics::TreeState state(robot.tree);
  state.set(motion.positions.col(0), motion.velocities.col(0));
  const auto point = buried(robot, state, {ground_m, motion.ground}, kAllowedDepth_m);
  if (!point) return;
  io::refuse(motion.file,
             fmt::format("at its first sample (t = {} s) {} is {:.3g} m below the ground at z "
                         "= {:.6g} m, where at most {:g} m is rounding; --ground-height states "
                         "another ground, --from a later start",
                         io::time_text(motion.times_s.front()), robot.contacts[point->contact].name,
                         point->depth_m, ground_m, kAllowedDepth_m));
}

void require_engine(const ReplayOptions& options) {
  if (options.engine->absence == nullptr) return;
  if (const auto absence = options.engine->absence()) io::refuse("--engine", *absence);
}

void require_replayable(const Robot& robot, const Motion& motion, const HopperReport& report,
                        const ReplayOptions& options) {
  if (!motion.has_base || !report.demand.has_dynamics) {
    io::refuse(motion.file, "holds no motion of the base: a replay begins with it");
  }
  if (robot.tree.base == dynamics::BaseKind::kFixed || robot.contacts.empty()) {
    io::refuse(motion.file,
               fmt::format("{} {}: a replay tells whether a robot stands or falls, which this one "
                           "cannot; `hopper check` judges its drives",
                           robot.name,
                           robot.contacts.empty() ? "has no contacts" : "is held by a fixed base"));
  }
  if (robot.drivetrains.empty()) {
    io::refuse(motion.file, fmt::format("{} has no drive that could do it", robot.name));
  }
  require_engine(options);
  require_few_steps(motion, options.run);
  require_start_above_ground(robot, motion, options.engine_options.ground_height_m);
  require_steps_follow_effects(robot, motion.positions.col(0), options.run.step_s);
}

TrackingOptions tracking_options(const Robot& robot, const ReplayOptions& options) {
  return {options.run.step_s * options.run.steps_per_control,
          options.clock,
          options.impact,
          options.acts_late || options.run.latency_steps > 0,
          options.tasks,
          [&robot, &options] {
            return drive_ranges(robot, {options.limits, options.conditions, {}, {}});
          },
          options.forward_m_s};
}

/// Hops at a commanded speed are judged by it: their places are not the motion's.
std::optional<Goal> commanded_goal(const std::vector<TimeInAir>& flights,
                                   const ReplayOptions& options) {
  if (!options.forward_m_s) return std::nullopt;
  Goal goal;
  goal.least_flights = goal.most_flights = static_cast<int>(flights.size());
  goal.forward_m_s = options.forward_m_s;
  for (const TimeInAir& flight : flights) goal.landings_s.push_back(flight.until_s);
  return goal;
}

}  // namespace

void require_few_steps(const Motion& motion, const RunOptions& run) {
  const double span_s = motion.duration_s() + run.stand_s;
  const double steps = std::ceil(span_s / run.step_s);
  if (steps <= kMostReplaySteps) return;
  io::refuse(motion.file,
             fmt::format("lasts {:.6g} s: with {:g} s of standing {:.3g} steps of {:g} s, where a "
                         "replay takes at most {:g}; take a part of it by --from and --until, "
                         "lengthen --step, or state the unit of its times if they are no seconds, "
                         "--column time_s=time:ms",
                         motion.duration_s(), run.stand_s, steps, run.step_s, kMostReplaySteps));
}

namespace {

/// In what a run may differ from others of the same motion, beside its robot.
struct Variation {
  RunOptions run;
  RunStart start;
  actuator::OperatingConditions conditions;
  Eigen::VectorXd further_friction_Nm;
  Eigen::VectorXd motor_strength_factor;
  Eigen::VectorXd gain_factor;
  std::function<void(std::uint64_t, Observation&)> sense;
};

}  // namespace

namespace {

ReplayOptions over_ground_of(const Motion& motion, ReplayOptions options) {
  options.run.profile = motion.ground;
  return options;
}

}  // namespace

struct Replay::Ready {
  Ready(const Robot& of, const Motion& motion, const HopperReport& report,
        const ReplayOptions& with)
      : robot(of),
        options(over_ground_of(motion, with)),
        reference(of, motion, report.contacts, report.torques_Nm),
        flights(flights_of(reference, report.flights)),
        goal(commanded_goal(flights, with)),
        controller(with.controller->prepare(of, reference, tracking_options(of, with))) {}

  Ready(const Robot& of, FreeRun run, const ReplayOptions& with)
      : robot(of),
        options(with),
        reference(std::move(run.ends)),
        goal(run.goal),
        controller(std::move(run.controller)) {}

  Variation plain() const {
    ReferenceInstant first;
    reference.at(reference.begins_s(), first);
    return {options.run, {first.position, first.velocity}, options.conditions, {}, {}, {}, {}};
  }

  ReplayedRun run(const Robot& of, const Variation& variation, const Watching& watching) const {
    EngineOptions on = options.engine_options;
    on.ground_height_m = variation.run.ground_height_m;
    on.profile = variation.run.profile;
    const Robot moved = without_free_rotors(of);
    const auto engine = options.engine->make(moved, on);
    const auto follows = controller->make();
    PoweredDrives drives(of, {options.limits, variation.conditions, variation.further_friction_Nm,
                              variation.motor_strength_factor});
    const RunParts parts{moved,
                         reference,
                         *engine,
                         *follows,
                         drives,
                         variation.start,
                         variation.gain_factor,
                         variation.sense,
                         watching.should_stop,
                         watching.on_progress};
    ReplayedRun done;
    done.record = run_replay(parts, variation.run);
    done.result = goal ? result_of(moved, reference, *goal, done.record, options.verdict,
                                   options.load_window_s)
                       : result_of(moved, reference, flights, done.record, options.verdict,
                                   options.load_window_s);
    judge_charge(of, variation.conditions, done.record, done.result);
    leave_open(effects_left_out(of), done.result);
    return done;
  }

  const Robot& robot;
  ReplayOptions options;
  Reference reference;
  std::vector<TimeInAir> flights;
  std::optional<Goal> goal;  ///< None where it is judged by the motion.
  std::unique_ptr<const ReadyController> controller;
};

Replay::Replay(const Robot& robot, const Motion& motion, const HopperReport& report,
               const ReplayOptions& options) {
  require_replayable(robot, motion, report, options);
  ready_ = std::make_unique<const Ready>(robot, motion, report, options);
}

Replay::Replay(const Robot& robot, FreeRun run, const ReplayOptions& options) {
  require_engine(options);
  ReferenceInstant first;
  run.ends.at(run.ends.begins_s(), first);
  dynamics::TreeState state(robot.tree);
  state.set(first.position, first.velocity);
  const double ground_m = options.engine_options.ground_height_m;
  if (const auto point = buried(robot, state, {ground_m, {}}, kAllowedDepth_m)) {
    io::refuse(robot.name,
               fmt::format("would begin with {} {:.3g} m below the ground at z = {:.6g} m",
                           robot.contacts[point->contact].name, point->depth_m, ground_m));
  }
  require_steps_follow_effects(robot, first.position, options.run.step_s);
  ready_ = std::make_unique<const Ready>(robot, std::move(run), options);
}

Replay::~Replay() = default;

const Reference& Replay::reference() const { return ready_->reference; }
const ReplayOptions& Replay::options() const { return ready_->options; }

ReplayedRun Replay::run(const Watching& watching) const {
  return ready_->run(ready_->robot, ready_->plain(), watching);
}

ReplayedRun Replay::run_trial(const Randomisation& randomisation, std::uint64_t seed,
                              std::size_t number, const Watching& watching) const {
  const Ready& ready = *ready_;
  const Trial trial = draw_trial(randomisation, ready.robot, seed, number);
  const Robot robot = perturbed(ready.robot, trial);
  const SensorNoise noise(randomisation.noise, ready.robot.tree, seed, number);
  SensorFilter filter(randomisation.noise, ready.robot.tree);
  Variation variation = ready.plain();
  variation.start = start_of(robot, ready.reference, trial);
  variation.conditions = conditions_of(trial, ready.options.conditions);
  variation.further_friction_Nm = trial.further_friction_Nm;
  variation.motor_strength_factor = trial.motor_strength_factor;
  variation.gain_factor = trial.controller_gain_factor;
  variation.run.ground_height_m += trial.ground_height_m;
  variation.run.latency_steps +=
      static_cast<int>(std::lround(trial.latency_s / variation.run.step_s));
  const bool filters = ready.options.filters_noise;
  variation.sense = [&noise, &filter, filters](std::uint64_t look, Observation& seen) {
    noise.disturb(look, seen.position, seen.velocity);
    if (filters) filter.estimate(seen.time_s, seen.position, seen.velocity);
  };
  return ready.run(robot, variation, watching);
}

std::vector<SweptStep> Replay::sweep(const Watching& watching) const {
  std::vector<SweptStep> swept;
  const RunOptions& usual = ready_->options.run;
  const double period_s = usual.step_s * usual.steps_per_control;
  const double latency_s = usual.step_s * usual.latency_steps;
  for (const double factor : {2.0, 1.0, 0.5, 0.25}) {
    Variation variation = ready_->plain();
    RunOptions& other = variation.run;
    other.steps_per_control =
        std::max(1, static_cast<int>(std::lround(usual.steps_per_control / factor)));
    other.step_s = period_s / other.steps_per_control;
    other.latency_steps = static_cast<int>(std::lround(latency_s / other.step_s));
    const bool is_known = std::any_of(swept.begin(), swept.end(), [&](const SweptStep& one) {
      return one.step_s == other.step_s;
    });
    if (is_known) continue;
    swept.push_back({other.step_s, ready_->run(ready_->robot, variation, watching).result});
    if (watching.should_stop && watching.should_stop()) break;
  }
  return swept;
}

}  // namespace torquewright::hopper
