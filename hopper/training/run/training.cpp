// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/run/training.hpp"

#include <algorithm>
#include <cmath>
#include <istream>
#include <iterator>
#include <limits>
#include <map>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "hopper/skill/policy_controller.hpp"
#include "hopper/training/run/staged_copy.hpp"
#include "hopper/training/task/task_ends.hpp"
#include "hopper/trials/eased.hpp"
#include "hopper/verdict/turn.hpp"
#include "learning/training/trainer.hpp"

namespace torquewright::hopper {
namespace {

constexpr const char* kTitle = "torquewright training 2";
constexpr std::uint64_t kJudgingSeed = 0x6a756467;  // its runs are none of the episodes

learning::TrainerOptions trainer_options(const ReadyTask& ready, const TrainingOptions& options) {
  const TaskLearning& learning = ready.task.learning;
  learning::TrainerOptions trainer;
  trainer.seed = options.seed;
  trainer.threads = options.threads;
  trainer.copies = learning.copies;
  trainer.steps_per_iteration = learning.steps_per_iteration;
  trainer.minibatch = learning.minibatch;
  trainer.discounts = {learning.discount};
  trainer.first_deviation = learning.first_deviation;
  trainer.least_deviation = learning.least_deviation;
  trainer.entropy = learning.entropy;
  trainer.actor_layers = trainer.critic_layers = learning.layers;
  return trainer;
}

/// A range about 0 for all joints; none of no width.
void add_about_zero(double half_width, std::vector<NamedRange>& ranges) {
  if (half_width > 0.0) ranges.push_back({{-half_width, half_width}, {}, ""});
}

/// What the task itself lets differ at the start, where the document says nothing of it.
EpisodeOptions with_start_of(const Task& task, EpisodeOptions episodes) {
  Randomisation& from = episodes.randomisation;
  if (from.initial_joint_position_rad.empty()) {
    add_about_zero(task.start_joint_rad, from.initial_joint_position_rad);
  }
  if (from.initial_joint_velocity_rad_s.empty()) {
    add_about_zero(task.start_joint_rad_s, from.initial_joint_velocity_rad_s);
  }
  return episodes;
}

/// What episodes go by, share of the randomisation after share.
std::vector<EpisodeOptions> stages_of(const ReadyTask& ready, const TrainingOptions& options) {
  std::vector<EpisodeOptions> stages;
  for (const double share : options.shares) {
    stages.push_back(with_start_of(ready.task, options.episodes));
    Randomisation& from = stages.back().randomisation;
    from = eased(std::move(from), ready.robot, share);
  }
  return stages;
}

/// Those that began where the task does: of the others a turn or a success says nothing.
void add_means(std::vector<EpisodeEnd> ends, TrainingProgress& progress) {
  std::erase_if(ends, [](const EpisodeEnd& end) { return !end.was_whole; });
  progress.episodes = ends.size();
  if (ends.empty()) return;
  const double share = 1.0 / static_cast<double>(ends.size());
  for (const EpisodeEnd& end : ends) {
    progress.did_share += end.did ? share : 0.0;
    progress.turned_rad += share * end.turned_rad;
    progress.clipped_share += share * end.clipped_share;
    progress.duration_s += share * end.time_s;
    progress.peak_cam_Nm_s += share * end.peak_cam_Nm_s;
    progress.peak_cav_rad_s += share * end.peak_cav_rad_s;
  }
}

void add_returns(TrainingProgress& progress) {
  const auto& episodes = progress.learned.episodes;
  for (const learning::EpisodeReport& episode : episodes) {
    progress.motion_return += episode.returns[0] / static_cast<double>(episodes.size());
    progress.barrier_return += episode.returns[1] / static_cast<double>(episodes.size());
  }
}

}  // namespace

struct Training::State {
  State(const ReadyTask& task, const TrainingOptions& with)
      : ready(task), options(with), stages(stages_of(task, with)) {
    const auto make = [this](int) {
      copies.push_back(std::make_shared<StagedCopy>());
      copies.back()->environment = std::make_unique<HopperEnvironment>(ready, stages.front());
      return staged_environment(copies.back(), stages);
    };
    trainer = std::make_unique<learning::Trainer>(HopperEnvironment::sizes(ready), make,
                                                  trainer_options(ready, options));
  }

  void judge(TrainingProgress& progress) {
    progress.judged =
        judged(ready, stages[stage], trainer->policy(), kJudgingSeed, options.judged_runs);
    const auto key = std::make_tuple(stage, progress.judged->succeeded,
                                     progress.motion_return + progress.barrier_return);
    if (!best || key > std::make_tuple(best_stage, best_judgement.succeeded, best_return)) {
      best = trainer->policy();
      best_judgement = *progress.judged;
      std::tie(best_stage, std::ignore, best_return) = key;
      progress.is_best = true;
    }
  }

  void advance_by(const Judgement& judgement) {
    const double share =
        static_cast<double>(judgement.succeeded) / static_cast<double>(judgement.runs);
    if (stage + 1 < stages.size() && share >= options.advancing_share) ask_for(stage + 1);
  }

  /// Asks for the stages in which the open episodes began, and returns that of the next ones.
  std::size_t ask_for_saved(const std::string& line) {
    std::istringstream words(line);
    const auto read = [&] {
      std::size_t of = 0;
      if (!(words >> of) || of >= stages.size()) {
        throw std::invalid_argument("went by other shares of the randomisation");
      }
      return of;
    };
    const std::size_t next = read();
    for (const auto& copy : copies) copy->asked_stage = read();
    return next;
  }

  void ask_for(std::size_t next) {
    stage = next;
    for (const auto& copy : copies) copy->asked_stage = next;
  }

  const ReadyTask& ready;
  TrainingOptions options;
  std::vector<EpisodeOptions> stages;
  std::size_t stage = 0;
  std::vector<std::shared_ptr<StagedCopy>> copies;
  std::unique_ptr<learning::Trainer> trainer;
  std::optional<learning::Policy> best;
  std::size_t best_stage = 0;
  Judgement best_judgement;
  double best_return = -std::numeric_limits<double>::infinity();
  TrainingProgress last;  ///< Of the last iteration, not judged.
};

Training::Training(const ReadyTask& ready, const TrainingOptions& options)
    : state_(std::make_unique<State>(ready, options)) {}
Training::~Training() = default;

TrainingProgress Training::iterate() {
  TrainingProgress progress;
  progress.randomised_share = state_->options.shares[state_->stage];
  progress.learned = state_->trainer->iterate();
  std::vector<EpisodeEnd> ends;
  for (const auto& copy : state_->copies) {
    std::vector<EpisodeEnd> ended = copy->environment->take_ended();
    std::move(ended.begin(), ended.end(), std::back_inserter(ends));
  }
  add_means(std::move(ends), progress);
  add_returns(progress);
  state_->last = progress;
  if (progress.learned.iteration % state_->options.judged_every == 0) {
    state_->judge(progress);
    state_->advance_by(*progress.judged);
  }
  return progress;
}

TrainingProgress Training::judge_now() {
  TrainingProgress progress = state_->last;
  state_->judge(progress);
  return progress;
}

const std::optional<learning::Policy>& Training::best() const { return state_->best; }
const Judgement& Training::best_judgement() const { return state_->best_judgement; }
const learning::Policy& Training::policy() const { return state_->trainer->policy(); }

void Training::save(std::ostream& out) const {
  out << kTitle << "\n"
      << state_->best_stage << " " << state_->best_judgement.succeeded << " "
      << state_->best_judgement.runs << " " << std::hexfloat << state_->best_return
      << std::defaultfloat << "\n"
      << state_->stage;
  for (const auto& copy : state_->copies) out << " " << copy->stage;
  out << "\n";
  state_->trainer->save(out);
}

void Training::restore(std::istream& in) {
  std::string title, numbers, stages;
  std::getline(in, title);
  std::getline(in, numbers);
  std::getline(in, stages);
  if (title != kTitle) throw std::invalid_argument("holds no state of a training");
  std::istringstream words(numbers);
  Judgement best;
  std::string best_return;
  std::size_t best_stage = 0;
  words >> best_stage >> best.succeeded >> best.runs >> best_return;
  const std::size_t stage = state_->ask_for_saved(stages);
  state_->trainer->restore(in);
  state_->ask_for(stage);
  state_->best_stage = best_stage;
  state_->best_judgement = best;
  state_->best_return = std::strtod(best_return.c_str(), nullptr);
  // The best policy itself stands in its document already.
  if (std::isfinite(state_->best_return)) state_->best = state_->trainer->policy();
}

ReplayOptions replay_options_of(const ReadyTask& ready, const EpisodeOptions& episodes) {
  ReplayOptions options;
  options.engine = episodes.engine;
  options.controller = &policy_kind;
  options.limits = episodes.limits;
  options.conditions = episodes.conditions;
  options.run.step_s = ready.task.step_s;
  options.run.steps_per_control = 1;
  options.verdict.standing.at_rest_s = 0.3;
  options.filters_noise = ready.task.filters_sensors;
  return options;
}

Judgement judged(const ReadyTask& ready, const EpisodeOptions& episodes,
                 const learning::Policy& policy, std::uint64_t seed, std::size_t runs) {
  const EpisodeOptions drawn = with_start_of(ready.task, episodes);
  const Replay replay(ready.robot,
                      {reference_of_ends(ready), ready.task.goal,
                       policy_controller(ready.robot, ready.skill, policy, {})},
                      replay_options_of(ready, drawn));
  Judgement judgement;
  std::map<std::string, int> reasons;
  for (std::size_t run = 0; run < runs; ++run) {
    const ReplayedRun done = replay.run_trial(drawn.randomisation, seed, run, {});
    ++judgement.runs;
    const ReplayOutcome& outcome = done.result.outcome;
    if (outcome.verdict == ReplayVerdict::kStands) ++judgement.succeeded;
    if (outcome.verdict != ReplayVerdict::kStands) ++reasons[outcome.reason];
    judgement.turned_rad += turned_rad(ready.robot.tree, done.record, done.record.end_s).y() /
                            static_cast<double>(runs);
  }
  const auto commonest = std::max_element(
      reasons.begin(), reasons.end(),
      [](const auto& one, const auto& other) { return one.second < other.second; });
  if (commonest != reasons.end()) judgement.commonest_reason = commonest->first;
  return judgement;
}

PolicyDocument document_of(const ReadyTask& ready, DriveLimits limits,
                           const learning::Policy& policy) {
  PolicyDocument document;
  document.task = ready.task.name;
  document.training_task = ready.task.text;
  document.filters_sensors = ready.task.filters_sensors;
  document.policy = policy;
  document.inputs = ready.skill.inputs;
  document.outputs = ready.skill.outputs;
  document.control_period_s = ready.task.control_period_s;
  document.limits = limits == DriveLimits::kBox ? "box" : "mor";
  const TargetGains& gains = ready.skill.gains;
  for (Eigen::Index joint = 0; joint < gains.stiffness_Nm_rad.size(); ++joint) {
    const auto body = static_cast<std::size_t>(joint) + 1;
    document.gains.push_back({ready.robot.tree.bodies[body].joint.name,
                              gains.stiffness_Nm_rad[joint], gains.damping_Nm_s_rad[joint]});
  }
  return document;
}

}  // namespace torquewright::hopper
