// SPDX-License-Identifier: Apache-2.0
#include "src/options/hopper_flip_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "hopper/flip/objectives/library.hpp"
#include "hopper/flip/tasks/library.hpp"
#include "io/nearest.hpp"
#include "io/spec_error.hpp"
#include "io/wording.hpp"
#include "src/options/named_sentences.hpp"

namespace torquewright::cli {
namespace {

constexpr std::int64_t kGreatestSeed = 4294967295;
// The solver holds constraints to some 1e-8 of numbers near 1: beyond these nothing of one or the
// other is left.
constexpr double kLeastWeight = 1e-6;
constexpr double kGreatestWeight = 1e6;

void add_task_options(command_line::Command& command, HopperFlipRequest& request) {
  command.add_option("--task", request.task, named_sentences(hopper::every_task(), "{}: {}", "; "))
      .one_of(hopper::task_names());
  command
      .add_option(
          "--rise", request.rise_m,
          "How far the centre of mass rises in the flight of a jump or a hop, at least, in m")
      .otherwise(fmt::format("{:g}", hopper::PlanOptions().rise_m))
      .between(0.0, 2.0);
  command
      .add_option("--stride", request.stride_m,
                  "How far a hop goes, in m; less than 0 is backwards")
      .otherwise(fmt::format("{:g}", hopper::PlanOptions().stride_m))
      .between(-2.0, 2.0);
  command
      .add_option("--limits", request.limits,
                  "What limits each drive: mor, its region at the voltage of the instant; box, its "
                  "peak torque at any speed up to no load, which a real motor cannot do")
      .one_of({"mor", "box"});
  command
      .add_option("--contacts", request.contacts,
                  "What stands on the ground, in order: flat, heel, toe, flight")
      .otherwise("the task's, of a flip flat,heel,flight,heel,flat")
      .separated_by_commas();
  command
      .add_option(
          "--objective", request.objectives,
          fmt::format("NAME[=WEIGHT]: what the plan makes small or great (docs/flip.md), of {}; "
                      "weights from 1e-6 to 1e6, 1 where none is stated",
                      fmt::join(hopper::objective_names(), ", ")))
      .otherwise("the task's")
      .one_value_each();
}

/// Planning margins: what a replay has left to steer with.
void add_margin_options(command_line::Command& command, hopper::PlanMargins& margins) {
  command
      .add_option("--voltage-margin", margins.voltage,
                  "Share of the bus voltage kept from a region's voltage bound")
      .between(0.0, 0.9);
  command
      .add_option("--current-margin", margins.current,
                  "Share of a region's current bound that is kept")
      .between(0.0, 0.9);
  command
      .add_option("--friction-margin", margins.friction,
                  "Share of the ground's friction coefficient that is kept")
      .between(0.0, 0.95);
  command
      .add_option("--center-of-pressure-margin", margins.center_of_pressure,
                  "Share of the foot's length kept from either end of it")
      .between(0.0, 0.49);
  command
      .add_option("--gear-margin", margins.gear_load,
                  "Share of each transmission's limit that is kept")
      .between(0.0, 0.9);
  command
      .add_option("--position-margin", margins.position_rad,
                  "How far joints keep from the ends of their ranges, in rad")
      .between(0.0, 1.0);
  command
      .add_option("--speed-margin", margins.speed, "Share of the joints' speed limits that is kept")
      .between(0.0, 0.9);
}

void add_search_options(command_line::Command& command, HopperFlipRequest& request) {
  hopper::PlanOptions& plan = request.plan;
  command
      .add_option("--intervals", plan.intervals,
                  "How many intervals the first mesh has, all phases together")
      .integer_between(10, 2000);
  command
      .add_option("--integration-error", plan.most_error_rad,
                  "How far a phase may end from where an independent integrator ends, in rad; the "
                  "mesh is refined until it is less")
      .between(1e-6, 0.1);
  command.add_option("--rounds", plan.most_rounds, "How often the mesh is refined, at most")
      .integer_between(0, 50);
  command
      .add_option("--iterations", plan.most_iterations,
                  "How many iterations the solver takes on one mesh, at most")
      .integer_between(1, 1000000);
  command
      .add_option("--time-limit", plan.most_seconds,
                  "End the search after so many seconds, with the best so far and exit code 3")
      .between(0.01, 1e7);
  command
      .add_option("--guess-noise", plan.guess_noise_rad,
                  "Standard deviation of what is added to the first guess's joint angles, in rad")
      .between(0.0, 1.0);
  command.add_option("--seed", request.guess_seed, "Seed of that noise")
      .integer_between(0, kGreatestSeed)
      .needs("--guess-noise");
  command.add_flag("--explain", plan.explain,
                   "Where no plan is found, look for the smallest change of one thing (voltage, "
                   "current, mass, a ratio) that makes one");
  command
      .add_option("--load-window", request.warm.check.load_window_s,
                  "Time over which a transmission's load is averaged, in s")
      .between(1e-6, 10.0);
}

void add_warm_options(command_line::Command& command, HopperFlipRequest& request) {
  command
      .add_option("--warm", request.warm.trajectory_file,
                  "Begin from this motion of the robot, a CSV as `hopper check` reads it")
      .otherwise("a guess of its own");
  add_column_options(command, request.warm, "--warm");
  hopper::ContactRule& contact = request.warm.check.contact;
  command
      .add_option("--contact-height", contact.height_m,
                  "Height up to which points touch the ground in that motion, in m")
      .otherwise("the motion's contact columns, else searched for")
      .between(0.0, 10.0)
      .needs("--warm");
  command
      .add_option(
          "--contact-speed", contact.speed_m_s,
          "Speed upwards or downwards up to which points touch the ground in that motion, in m/s")
      .otherwise("the motion's contact columns, else searched for")
      .between(0.0, 100.0)
      .needs("--warm");
}

void add_file_options(command_line::Command& command, HopperFlipRequest& request) {
  command
      .add_option("-o,--output", request.motion_file,
                  "Write the plan to this CSV, a motion that `hopper check` and `hopper replay` "
                  "read; only a plan is written. With --sweep: write its result to this file")
      .names_a_file();
  command
      .add_option("--write-best", request.best_file,
                  "Where no plan is found, write the motion that comes closest to this CSV: it is "
                  "no plan")
      .names_a_file();
  command
      .add_option("--sample-step", request.plan.sample_s, "Time between rows of the motion, in s")
      .between(1e-5, 0.05);
  command
      .add_option(
          "--plot-momentum", request.momentum_file,
          "Draw CAM (centroidal angular momentum), CAV (the mean angular velocity that goes with "
          "it) and the composite inertia about the lateral axis over time to this SVG or PNG")
      .names_a_file();
  command
      .add_option("--figures", request.figures_file,
                  "Draw the robot at moments of the motion to this SVG")
      .names_a_file();
  command
      .add_option("--report", request.report_file,
                  "Write a page with the plan and all that `hopper check` says of it to this HTML")
      .names_a_file();
  command.add_flag("--json", request.json, "Print the answer as JSON");
  command.add_flag("--timing", request.timing, "State the seconds (runs then differ in bytes)");
}

[[noreturn]] void refuse_objective(const std::string& text, const std::string& why) {
  throw io::SpecError({{"command line", "--objective " + text, why}});
}

double read_weight(const std::string& text, const std::string& number) {
  char* end = nullptr;
  const double weight = std::strtod(number.c_str(), &end);
  if (number.empty() || *end != '\0' || !std::isfinite(weight)) {
    refuse_objective(text, "WEIGHT is a number");
  }
  if (!(weight >= kLeastWeight && weight <= kGreatestWeight)) {
    refuse_objective(text,
                     "WEIGHT is from 1e-6 to 1e6: 1 is usual, and far from it the solver loses "
                     "the constraints, or the objective, in rounding");
  }
  return weight;
}

}  // namespace

void add_hopper_flip_options(command_line::Command& command, HopperFlipRequest& request) {
  command.add_option("robot", request.warm.robot_file, "Document of kind robot").required();
  add_task_options(command, request);
  add_margin_options(command, request.plan.margins);
  add_operating_options(command, request.warm.operating);
  add_search_options(command, request);
  add_warm_options(command, request);
  add_sweep_options(command, request.sweep);
  add_file_options(command, request);
}

std::vector<hopper::WeightedObjective> read_objectives(const std::vector<std::string>& texts) {
  std::vector<hopper::WeightedObjective> objectives;
  const std::vector<std::string> known = hopper::objective_names();
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      const auto near = io::nearest(name, known);
      refuse_objective(text, fmt::format("no such objective{}",
                                         near ? fmt::format("; did you mean \"{}\"?", *near)
                                              : fmt::format("; there are {}", io::listed(known))));
    }
    for (const hopper::WeightedObjective& other : objectives) {
      if (other.name == name) refuse_objective(text, "stands twice: one weight is enough");
    }
    const double weight =
        equals == std::string::npos ? 1.0 : read_weight(text, text.substr(equals + 1));
    objectives.push_back({name, weight});
  }
  return objectives;
}

}  // namespace torquewright::cli
