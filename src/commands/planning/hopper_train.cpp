// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "hopper/check/hopper_check.hpp"
#include "hopper/engines/library.hpp"
#include "hopper/motion/motion_reader.hpp"
#include "hopper/policy/policy_spec.hpp"
#include "hopper/training/run/training.hpp"
#include "hopper/training/task/task_spec.hpp"
#include "hopper/trials/randomisation_spec.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/atomic_file.hpp"
#include "io/files/kept_state.hpp"
#include "robot/model/robot_spec.hpp"
#include "src/commands/robot/hopper_commands.hpp"
#include "src/interrupt.hpp"
#include "src/options/hopper_train_request.hpp"
#include "src/options/output_files.hpp"
#include "src/report/parts/progress_line.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
/// Share of the judged runs from which on a policy has learned its task.
constexpr double kLearned = 0.9;

constexpr const char* kCurveTitle =
    "iteration,steps,episodes,did_share,turned_rad,duration_s,clipped_share,peak_cam_Nm_s,"
    "peak_cav_rad_s,motion_return,barrier_return,kl,learning_rate,deviation,judged_succeeded,"
    "judged_runs,judged_turned_rad\n";

std::string curve_row(const hopper::TrainingProgress& at) {
  std::string row = fmt::format(
      "{},{},{},{:.4g},{:.5g},{:.5g},{:.4g},{:.5g},{:.5g},{:.6g},{:.6g},{:.4g},{:.4g},{:.4g}",
      at.learned.iteration, at.learned.steps, at.episodes, at.did_share, at.turned_rad,
      at.duration_s, at.clipped_share, at.peak_cam_Nm_s, at.peak_cav_rad_s, at.motion_return,
      at.barrier_return, at.learned.kl, at.learned.learning_rate, at.learned.deviation);
  if (!at.judged) return row + ",,,\n";
  return row + fmt::format(",{},{},{:.5g}\n", at.judged->succeeded, at.judged->runs,
                           at.judged->turned_rad);
}

std::string state_file(const HopperTrainRequest& request) {
  return request.policy_file + ".training";
}

/// A training and what it is written to.
class TrainingRun {
 public:
  explicit TrainingRun(const HopperTrainRequest& request)
      : request_(request),
        read_(hopper::read_robot(request.robot_file)),
        ready_(hopper::ready_task(read_.robot, hopper::read_task(request.task))),
        mid_states_(followed()),
        training_(made()) {
    if (request.resume) resume();
  }

  ExitCode go() {
    const auto began = std::chrono::steady_clock::now();
    report::ProgressLine progress;
    bool is_judged = false;
    for (std::uint64_t i = 0; !is_interrupted(); ++i) {
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - began;
      const bool is_enough = request_.iterations > 0 && i >= request_.iterations;
      if (is_enough || (i > 0 && passed.count() > request_.seconds)) break;
      const hopper::TrainingProgress at = training_->iterate();
      if (i == 0 && request_.resume) keep_curve_until(at.learned.iteration);
      note(at);
      is_judged = at.judged.has_value();
      progress.show(line(at));
    }
    if (!is_judged) note(training_->judge_now());
    return answer();
  }

 private:
  hopper::DriveLimits limits() const {
    return request_.limits == "box" ? hopper::DriveLimits::kBox : hopper::DriveLimits::kMor;
  }

  hopper::TrainingOptions options() const {
    hopper::TrainingOptions options;
    hopper::EpisodeOptions& episodes = options.episodes;
    episodes.engine = &hopper::engine_named(request_.engine);
    if (episodes.engine->absence != nullptr) {
      if (const auto absence = episodes.engine->absence()) io::refuse("--engine", *absence);
    }
    episodes.limits = limits();
    episodes.conditions = stated_conditions(request_.operating);
    if (!request_.randomise_file.empty()) {
      episodes.randomisation = hopper::read_randomisation(request_.randomise_file).randomisation;
      hopper::require_fits(episodes.randomisation, ready_.robot);
    }
    if (request_.eases) {
      if (request_.randomise_file.empty()) io::refuse("--curriculum", "needs --randomise");
      options.shares = {0.0, 0.25, 0.5, 0.75, 1.0};
    }
    episodes.mid_states = mid_states_;
    options.seed = request_.seed;
    options.threads = request_.threads;
    options.judged_every = request_.judged_every;
    options.judged_runs = request_.judged_runs;
    return options;
  }

  /// The motion of --reference and what it asks of the joints.
  hopper::Motion reference() const {
    hopper::MotionFile source;
    source.file = request_.reference_file;
    hopper::Motion motion = hopper::read_motion(read_.robot, source);
    const hopper::HopperReport report = hopper::check_motion(read_.robot, motion, {});
    motion.efforts = report.demand.joint_effort;
    return motion;
  }

  /// A task that pays for following has nothing to learn from without a motion.
  void require_nothing_followed() const {
    const auto& rewards = ready_.task.rewards;
    for (std::size_t i = 0; i < rewards.size(); ++i) {
      if (std::string_view(rewards[i].term->name) != "follow") continue;
      io::refuse("--reference",
                 fmt::format("is missing: the task {} follows a motion (/rewards/{}), such as "
                             "torquewright hopper flip writes",
                             ready_.task.name, i));
    }
  }

  /// Lays the task on the motion of --reference, if there is one.
  std::shared_ptr<const std::vector<hopper::MidState>> followed() {
    if (request_.reference_file.empty()) {
      require_nothing_followed();
      return nullptr;
    }
    const hopper::Motion motion = reference();
    const hopper::TimeInAir flight = hopper::flight_of(ready_, motion);
    ready_ = hopper::ready_task(read_.robot,
                                hopper::with_flight(ready_.task, flight.from_s, flight.until_s));
    auto states =
        std::make_shared<const std::vector<hopper::MidState>>(hopper::mid_states(ready_, motion));
    hopper::set_course(*states, ready_.skill);
    return states;
  }

  std::unique_ptr<hopper::Training> made() const {
    try {
      return std::make_unique<hopper::Training>(ready_, options());
    } catch (const std::invalid_argument& error) {
      io::refuse(ready_.task.file, fmt::format("/learning cannot be: {}", error.what()));
    }
  }

  void resume() {
    std::istringstream in(io::read_kept_state(state_file(request_)));
    try {
      training_->restore(in);
    } catch (const std::invalid_argument& error) {
      io::refuse(state_file(request_), error.what());
    }
  }

  /// Of a resumed training: rows from before it was left.
  void keep_curve_until(std::int64_t iteration) {
    if (request_.curve_file.empty() || !std::filesystem::exists(request_.curve_file)) return;
    std::istringstream in(io::read_kept_state(request_.curve_file));
    std::string row;
    while (std::getline(in, row)) {
      const long of = std::strtol(row.c_str(), nullptr, 10);
      if (of > 0 && of < iteration) rows_ += row + "\n";
    }
  }

  void note(const hopper::TrainingProgress& at) {
    rows_ += curve_row(at);
    if (!at.judged) return;
    std::vector<io::FileContent> files;
    if (at.is_best) files.push_back({request_.policy_file, policy_text()});
    std::ostringstream state;
    training_->save(state);
    files.push_back({state_file(request_), state.str()});
    if (!request_.curve_file.empty()) files.push_back({request_.curve_file, kCurveTitle + rows_});
    io::write_whole_files(files);
  }

  std::string policy_text() const {
    hopper::PolicyDocument document = hopper::document_of(ready_, limits(), *training_->best());
    for (const io::Document& one : read_.documents) {
      document.trained_with.push_back({one.file, one.sha256});
    }
    return hopper::policy_text(document);
  }

  std::string line(const hopper::TrainingProgress& at) const {
    const hopper::Judgement& best = training_->best_judgement();
    return fmt::format(
        "{} steps: {:.0f} % do it, {:.0f} degrees, clipped {:.1f} %, {:.2f} s; best {} of {} runs",
        at.learned.steps, 100.0 * at.did_share, kDegrees * at.turned_rad, 100.0 * at.clipped_share,
        at.duration_s, best.succeeded, best.runs);
  }

  ExitCode answer() const {
    const hopper::Judgement& best = training_->best_judgement();
    std::string text = fmt::format(
        "{}: {} of {} runs of the best policy do the task and {} in the engine \"{}\"\n",
        request_.policy_file, best.succeeded, best.runs,
        ready_.task.goal.rests ? "stand" : "stay up", request_.engine);
    if (!best.commonest_reason.empty()) {
      text += fmt::format(
          "  most of the others: {} (turned by {:.0f} of {:.0f} degrees in the "
          "mean of all)\n",
          best.commonest_reason, kDegrees * best.turned_rad, kDegrees * ready_.task.goal.turn_rad);
    }
    text += fmt::format("next: torquewright hopper replay {} {}\n", request_.robot_file,
                        request_.policy_file);
    print_result(for_window(text));
    const bool has_learned =
        static_cast<double>(best.succeeded) >= kLearned * static_cast<double>(best.runs);
    return has_learned ? ExitCode::kPasses : ExitCode::kUndecided;
  }

  const HopperTrainRequest& request_;
  hopper::ReadRobot read_;
  hopper::ReadyTask ready_;
  std::shared_ptr<const std::vector<hopper::MidState>> mid_states_;
  std::unique_ptr<hopper::Training> training_;
  std::string rows_;
};

ExitCode run_hopper_train(const HopperTrainRequest& request) {
  if (request.policy_file.empty()) {
    io::refuse("--output", "is required: the file that the policy is written to");
  }
  io::check_outputs(named({request.policy_file, state_file(request), request.curve_file}),
                    named({request.robot_file, request.randomise_file, request.reference_file}));
  catch_interrupt();
  try {
    return TrainingRun(request).go();
  } catch (const std::domain_error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return ExitCode::kUndecided;
  }
}

}  // namespace

void add_train_command(command_line::Command& hopper) {
  auto request = std::make_shared<HopperTrainRequest>();
  command_line::Command command =
      hopper.add_command("train", "Learn a policy that does a task with these actuators");
  add_hopper_train_options(command, *request);
  command.example(
      "torquewright hopper train specs/robot/hopper.json --task stand --iterations 1 -o "
      "stand.json");
  command.works([request] { return run_hopper_train(*request); });
}

}  // namespace torquewright::cli
