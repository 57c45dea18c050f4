// SPDX-License-Identifier: Apache-2.0
#include "src/options/hopper_flip_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "hopper/engines/library.hpp"
#include "hopper/planning/objectives/library.hpp"
#include "hopper/planning/tasks/library.hpp"
#include "hopper/planning/tasks/reserve.hpp"
#include "hopper/tracking/library.hpp"
#include "src/options/named_sentences.hpp"

namespace torquewright::cli {
namespace {

using command_line::Command;

constexpr std::int64_t kGreatestSeed = 4294967295;
constexpr std::int64_t kMostRepeats = 12;  // one programme holds all: a minute or two

// Where results state options: before and behind the task's, margins' and search's, at 0.
constexpr int kTaskPlace = -2;  // of sweeps alone
constexpr int kFilesPlace = 1;
constexpr int kWarmPlace = 2;
constexpr int kExplanationPlace = 3;
constexpr int kTrialsPlace = 4;

void add_task_options(Command& command, HopperFlipRequest& request) {
  const hopper::PlanOptions usual;
  command.add_option("--task", request.task, named_sentences(hopper::every_task(), "{}: {}", "; "))
      .one_of(hopper::task_names())
      .stated_elsewhere_as("task", kTaskPlace);
  command
      .add_option("--rise", request.rise_m,
                  "How far the centre of mass rises in the flight of a jump or a hop, at least, "
                  "in m")
      .otherwise(fmt::format("{:g}", usual.rise_m))
      .between(0.0, 2.0)
      .stated_as("rise_m");
  command
      .add_option("--stride", request.stride_m,
                  "How far a hop goes, in m; less than 0 is backwards")
      .otherwise("0.1, or what --speed makes")
      .between(-2.0, 2.0)
      .stated_as("stride_m");
  command
      .add_option("--speed", request.speed_m_s,
                  "Mean speed of hops in m/s, from the first take-off to the last touch-down "
                  "(--alike: the last take-off); "
                  "without --stride it makes the stride; less than 0 is backwards")
      .otherwise("free")
      .between(-5.0, 5.0)
      .stated_as("speed_m_s");
  command
      .add_option("--repeat", request.plan.repeat,
                  "How many jumps or hops follow each other without a rest")
      .integer_between(1, kMostRepeats)
      .stated_as("repeat");
  command
      .add_flag(
          "--alike", request.plan.has_alike_hops,
          "Every flight begins as the one before: such hops go on and on, `hopper replay --hops`")
      .needs("--repeat")
      .stated_as("alike");
  command
      .add_option("--land-at", request.plan.landings_m,
                  "How much higher the ground is where a hop lands, in m, over that where the "
                  "motion begins; of several hops in order, the last for all that follow: 0,0.085 "
                  "steps up at the second")
      .otherwise("flat ground")
      .separated_by_commas()
      .between(-1.0, 1.0)
      .stated_as("land_at_m");
}

void add_plan_options(Command& command, HopperFlipRequest& request) {
  command
      .add_option("--limits", request.limits,
                  "What limits each drive: mor, its region at the voltage of the instant; box, its "
                  "peak torque at any speed up to no load, which a real motor cannot do")
      .one_of({"mor", "box"})
      .stated_elsewhere_as("limits", kTaskPlace);
  command
      .add_option("--contacts", request.plan.stances,
                  "What stands on the ground, in order: flat, heel, toe, flight")
      .otherwise("the task's, of a flip flat,heel,flight,heel,flat")
      .separated_by_commas()
      .stated_as("contacts");
  command
      .add_option("--objective", request.objectives,
                  fmt::format("NAME[=WEIGHT]: what the plan makes small or great (docs/flip.md), "
                              "of {}; weights from 1e-6 to 1e6, 1 where none is stated",
                              fmt::join(hopper::objective_names(), ", ")))
      .otherwise("the task's")
      .one_value_each()
      .stated_as("objective");
}

void add_duration_options(Command& command, hopper::LongestPhases& longest) {
  const auto add = [&command](const std::string& name, const std::string& key, double& phase_s,
                              double least_s, const std::string& of) {
    command.add_option("--longest-" + name, phase_s, "How long " + of + " takes at most, in s")
        .between(least_s, 10.0)
        .stated_as("longest_" + key + "_s");
  };
  add("first", "first", longest.first_s, 0.2, "the first phase");
  add("push-off", "push_off", longest.push_off_s, 0.02, "a phase between the first and the flight");
  add("flight", "flight", longest.flight_s, 0.05, "a flight");
  add("landing", "landing", longest.landing_s, 0.02, "a phase between the flight and the last");
  add("between", "between", longest.between_s, 0.05, "a stance between two flights");
  add("last", "last", longest.last_s, 0.4, "the last phase");
}

/// "--position-margin" in rad is "position_margin_rad".
std::string margin_key(const hopper::MarginPart& part) {
  std::string key(part.option.substr(2));
  std::replace(key.begin(), key.end(), '-', '_');
  return part.unit.empty() ? key : key + "_" + std::string(part.unit);
}

/// What the reserve makes of each margin, in words.
std::string reserve_words() {
  std::vector<std::string> words;
  for (const hopper::MarginPart& part : hopper::margin_parts()) {
    if (!(part.per_reserve > 0.0)) continue;
    words.push_back(fmt::format("{} {:g}{}{}", part.option.substr(2), part.per_reserve,
                                part.unit.empty() ? "" : " ", part.unit));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

/// Planning margins: what a replay has left to steer with.
void add_margin_options(Command& command, HopperFlipRequest& request) {
  command
      .add_option("--reserve", request.plan.reserve,
                  fmt::format("One word for the margins below: each is at least so many times this "
                              "share: {}; what is stated by itself holds",
                              reserve_words()))
      .between(0.0, 1.0)
      .stated_as("reserve");
  const hopper::PlanMargins usual;
  for (std::size_t i = 0; i < hopper::margin_parts().size(); ++i) {
    const hopper::MarginPart& part = hopper::margin_parts()[i];
    command.add_option(std::string(part.option), request.margins[i], std::string(part.sentence))
        .otherwise(fmt::format("{:g}, or what --reserve makes of it", usual.*part.margin))
        .between(0.0, part.most)
        .stated_as(margin_key(part));
  }
}

void add_search_options(Command& command, HopperFlipRequest& request) {
  hopper::PlanOptions& plan = request.plan;
  command
      .add_option("--intervals", plan.intervals,
                  "How many intervals the first mesh has, all phases of one flight together")
      .integer_between(10, 2000)
      .stated_as("intervals");
  command
      .add_option("--integration-error", plan.most_error_rad,
                  "How far a phase may end from where an independent integrator ends, in rad; the "
                  "mesh is refined until it is less")
      .between(1e-6, 0.1)
      .stated_as("integration_error_rad");
  command.add_option("--rounds", plan.most_rounds, "How often the mesh is refined, at most")
      .integer_between(0, 50)
      .stated_as("rounds");
  command
      .add_option("--iterations", plan.most_iterations,
                  "How many iterations the solver takes on one mesh, at most")
      .integer_between(1, 1000000)
      .stated_as("iterations");
  command
      .add_option("--time-limit", plan.most_seconds,
                  "End the search after so many seconds, with the best so far and exit code 3")
      .between(0.01, 1e7)
      .stated_as("time_limit_s");
  command
      .add_option("--guess-noise", plan.guess_noise_rad,
                  "Standard deviation of what is added to the first guess's joint angles, in rad")
      .between(0.0, 1.0)
      .stated_as("guess_noise_rad");
  command.add_option("--seed", request.guess_seed, "Seed of that noise")
      .integer_between(0, kGreatestSeed)
      .needs("--guess-noise")
      .stated_as("seed");
  command
      .add_flag("--explain", plan.explain,
                "Where no plan is found, look for the smallest change of one thing (voltage, "
                "current, mass, a ratio) that makes one")
      .stated_as("explain", kExplanationPlace)
      .of_one_answer();
}

/// How a motion is read that a search begins from, and how loads are counted.
void add_warm_options(Command& command, HopperFlipRequest& request) {
  add_load_window(command, request.warm.check).stated_as("load_window_s", kWarmPlace);
  command
      .add_option("--warm", request.warm.trajectory_file,
                  "Begin from this motion of the robot, a CSV as `hopper check` reads it")
      .otherwise("a guess of its own")
      .stated_as("warm", kWarmPlace);
  add_column_options(command, request.warm, "--warm");
  const std::string contacts = "the motion's contact columns, else searched for";
  command
      .add_option("--contact-height", request.warm.check.contact.height_m,
                  "Height up to which points touch the ground in that motion, in m")
      .otherwise(contacts)
      .between(0.0, 10.0)
      .needs("--warm")
      .stated_as("contact_height_m", kWarmPlace);
  command
      .add_option("--contact-speed", request.warm.check.contact.speed_m_s,
                  "Speed upwards or downwards up to which points touch the ground in that motion, "
                  "in m/s")
      .otherwise(contacts)
      .between(0.0, 100.0)
      .needs("--warm")
      .stated_as("contact_speed_m_s", kWarmPlace);
}

/// Whether plans survive.
void add_trial_options(Command& command, HopperFlipRequest& request) {
  SweptTrials& trials = request.trials;
  command
      .add_option("--trials", trials.count,
                  "Replay each plan of --sweep or --robust so often, randomised, as hopper replay "
                  "does: the share that does the motion and stands")
      .otherwise("none")
      .integer_between(1, 1000000)
      .stated_as("trials", kTrialsPlace);
  command
      .add_option(
          "--robust", request.robust_file,
          "Document of kind randomisation: plan with reserves from --reserve on, each within "
          "--time-limit, try each plan in --trials, and keep the one that most of them do")
      .otherwise("the reserve as it is stated")
      .needs("--trials")
      .stated_as("robust", kTrialsPlace);
  command
      .add_option("--randomise", trials.randomise_file,
                  "Document of kind randomisation, which says what differs from trial to trial")
      .otherwise("what the robot is")
      .needs("--trials");
  command
      .add_option("--trial-seed", trials.seed,
                  "Seed of the numbers that trials draw, --seed of hopper replay")
      .needs("--trials")
      .stated_as("trial_seed", kTrialsPlace);
  command
      .add_option("--controller", trials.controller,
                  "What follows the plan in trials: " +
                      named_sentences(hopper::every_controller(), "{}, {}", "; "))
      .one_of(hopper::controller_names())
      .needs("--trials")
      .stated_as("controller", kTrialsPlace);
  command
      .add_option("--engine", trials.engine,
                  "Which engine simulates trials: " +
                      named_sentences(hopper::every_engine(), "{} ({})", " or "))
      .one_of(hopper::engine_names())
      .needs("--trials")
      .stated_as("engine", kTrialsPlace);
}

void add_motion_files(Command& command, HopperFlipRequest& request) {
  command
      .add_option("-o,--output", request.motion_file,
                  "Write the plan to this CSV, a motion that `hopper check` and `hopper replay` "
                  "read; only a plan is written. With --sweep: write its result to this file")
      .names_a_file();
  command
      .add_option("--write-best", request.best_file,
                  "Where no plan is found, write the motion that comes closest to this CSV: it is "
                  "no plan")
      .names_a_file()
      .of_one_answer();
  command
      .add_option("--sample-step", request.plan.sample_s, "Time between rows of the motion, in s")
      .between(1e-5, 0.05)
      .stated_as("sample_step_s", kFilesPlace);
}

void add_pictures(Command& command, HopperFlipRequest& request) {
  command
      .add_option("--plot-momentum", request.momentum_file,
                  "Draw CAM (centroidal angular momentum), CAV (the mean angular velocity that "
                  "goes with it) and the composite inertia about the lateral axis over time to "
                  "this SVG or PNG")
      .names_a_file()
      .of_one_answer();
  command
      .add_option("--figures", request.figures_file,
                  "Draw the robot at moments of the motion to this SVG")
      .names_a_file()
      .of_one_answer();
  command
      .add_option("--report", request.report_file,
                  "Write a page with the plan and all that `hopper check` says of it to this HTML")
      .names_a_file()
      .of_one_answer();
  command.add_flag("--json", request.json, "Print the answer as JSON");
  command.add_flag("--timing", request.timing, "State the seconds (runs then differ in bytes)")
      .of_one_answer();
}

}  // namespace

void add_hopper_flip_options(Command& command, HopperFlipRequest& request) {
  request.declared = &command.declared();
  command.add_option("robot", request.warm.robot_file, "Document of kind robot").required();
  add_task_options(command, request);
  add_plan_options(command, request);
  add_duration_options(command, request.plan.longest);
  add_margin_options(command, request);
  add_operating_options(command, request.warm.operating);
  add_search_options(command, request);
  add_warm_options(command, request);
  add_sweep_options(command, request.sweep);
  add_trial_options(command, request);
  add_motion_files(command, request);
  add_pictures(command, request);
}

}  // namespace torquewright::cli
