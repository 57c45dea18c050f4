// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "identification/robot_plan/robot_plan.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/atomic_file.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"
#include "robot/model/robot_spec.hpp"
#include "src/commands/identification/identify_plan_request.hpp"
#include "src/commands/identification/simulated_robot.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/commands/shared/stated_json.hpp"
#include "src/loudness.hpp"
#include "src/options/noise_option.hpp"
#include "src/report/identification/robot_plan_json.hpp"
#include "src/report/identification/robot_plan_text.hpp"
#include "src/report/parts/progress_line.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

using identification::Rig;
using identification::RobotPlan;
using identification::RobotPlanOptions;

IdentifyInputs inputs_of(const PlanRequest& request) {
  IdentifyRequest identify;
  identify.rig_file = request.rig;
  identify.robot_file = request.robot;
  identify.actuators = request.of_joints;
  IdentifyInputs inputs = read_inputs(identify);
  const std::string why_not = not_simulated_sentence(inputs);
  if (!why_not.empty()) io::refuse("--rig", why_not);
  for (std::size_t joint = 0; joint < inputs.rig.joints.size(); ++joint) {
    if (inputs.rig.controllers[joint]->states_stiffness) continue;
    io::refuse("--rig",
               fmt::format("the controller of {} states no gain; a plan needs one to begin "
                           "with: write \"stiffness_Nm_rad\", and name it under "
                           "\"uncertain\"",
                           inputs.rig.joints[joint]));
  }
  return inputs;
}

hopper::Robot robot_of(const Rig& rig) {
  const std::filesystem::path beside = std::filesystem::path(rig.file).parent_path();
  return hopper::read_robot(beside / rig.load.robot->file).robot;
}

const hopper::Posture& posture_called(const hopper::Robot& robot, const std::string& name) {
  std::vector<std::string> names;
  for (const hopper::Posture& each : robot.postures) {
    if (each.name == name) return each;
    names.push_back(each.name);
  }
  if (names.empty()) {
    io::refuse("--posture", fmt::format("the robot has no postures, and none called {}", name));
  }
  const auto near = io::nearest(name, names);
  io::refuse("--posture", fmt::format("the robot has no posture \"{}\"; {}", name,
                                      near ? fmt::format("did you mean \"{}\"?", *near)
                                           : "they are " + io::listed(names)));
}

/// In the middle of what the joint's limits allow; where one of them is not stated, at zero or the
/// nearest that is allowed.
double middle_rad(const dynamics::JointLimits& limits) {
  const double middle = 0.5 * (limits.position_min + limits.position_max);
  return std::isfinite(middle) ? middle : std::clamp(0.0, limits.position_min, limits.position_max);
}

/// Where the joints begin and end.
std::vector<double> centre_rad(const PlanRequest& request, const Rig& rig,
                               const hopper::Robot& robot) {
  const hopper::Posture* posture = hopper::standing_posture(robot.postures);
  if (!request.posture.empty()) posture = &posture_called(robot, request.posture);
  std::vector<double> centre;
  for (const std::size_t body : rig.load.robot->bodies) {
    centre.push_back(posture != nullptr ? posture->joints[static_cast<Eigen::Index>(body) - 1]
                                        : middle_rad(robot.tree.bodies[body].joint.limits));
  }
  return centre;
}

/// The last runs are those that the rig holds out, if it names any.
std::vector<std::string> run_names(const Rig& rig) {
  constexpr std::size_t kRuns = 4;
  std::vector<std::string> names = rig.holdout_runs;
  for (std::size_t k = 1; names.size() < std::max(kRuns, rig.holdout_runs.size() + 1); ++k)
    names.insert(names.end() - static_cast<std::ptrdiff_t>(rig.holdout_runs.size()),
                 std::to_string(k));
  return names;
}

RobotPlanOptions options_of(const PlanRequest& request, const Rig& rig) {
  constexpr double kShortest_s = 8.0, kLongest_s = 600.0;
  RobotPlanOptions options;
  options.duration_s = request.options.duration_s;
  if (!(options.duration_s >= kShortest_s && options.duration_s <= kLongest_s)) {
    io::refuse("--duration", fmt::format("{:g} s is not between {:g} and {:g} s",
                                         options.duration_s, kShortest_s, kLongest_s));
  }
  if (!request.options.separate.empty()) {
    io::refuse("--separate",
               "a robot's plan is for all of its values: rotors, friction, encoders, bodies; "
               "leave the option out");
  }
  options.seed = request.options.seed;
  constexpr double kUnlimited = std::numeric_limits<double>::infinity();
  options.limits.speed_rad_s = request.options.limits.speed_rad_s.value_or(kUnlimited);
  options.limits.from_start_rad = request.options.limits.position_rad.value_or(kUnlimited);
  options.limits.base_height_m = request.base_height_m;
  for (const auto& [quantity, sigma] : read_noise(request.noise, rig)) {
    if (quantity != identification::Quantity::kOutputPosition) {
      io::refuse("--noise", fmt::format("{}: a robot's plan is for its positions alone; "
                                        "output_position_rad=SIGMA is their noise",
                                        identification::name_of(quantity)));
    }
    if (!(sigma > 0.0)) {
      io::refuse("--noise",
                 "output_position_rad=0: without noise every value is told; it must be "
                 "above 0 rad");
    }
    options.position_noise_rad = sigma;
  }
  options.runs = run_names(rig);
  return options;
}

void check_files(const PlanRequest& request, const IdentifyInputs& inputs) {
  if (is_standard_output(request.excitation) && request.json) {
    io::refuse("--json", "standard output takes the commands of -o -");
  }
  if (request.excitation.empty()) return;
  std::vector<std::filesystem::path> read = {request.rig};
  for (const io::Document& document : inputs.robot_documents) read.emplace_back(document.file);
  check_written({request.excitation}, read);
}

std::string next_step(const PlanRequest& request) {
  if (request.excitation.empty()) return "next: -o commands.csv writes the commands to be played\n";
  return fmt::format(
      "Written: {}\nnext: play it, log the positions, torquewright identify LOG --rig {}\n",
      request.excitation, request.rig);
}

}  // namespace

ExitCode run_robot_plan(const PlanRequest& request) {
  const IdentifyInputs inputs = inputs_of(request);
  const hopper::Robot robot = robot_of(inputs.rig);
  const RobotPlanOptions options = options_of(request, inputs.rig);
  if (request.base_height_m && robot.contacts.empty() && robot.spheres.empty()) {
    io::refuse("--base-height",
               "the robot states neither \"contacts\" nor \"collision_spheres\": nothing of it is "
               "known that could touch the ground");
  }
  check_files(request, inputs);
  report::ProgressLine progress;
  const RobotPlan plan = identification::plan_robot(
      stated_model(inputs), robot, centre_rad(request, inputs.rig, robot), options,
      [&](double share) { progress.show(fmt::format("motions tried: {:.0f} %", 100.0 * share)); });
  std::vector<io::Document> documents = inputs.robot_documents;
  documents.push_back(inputs.rig_document);
  std::string text;
  if (request.json) {
    text = result_text(
        report::robot_plan_json(plan, options, inputs.rig.joints, stated_json(*request.declared)),
        documents);
  } else {
    text = report::robot_plan_text(plan, options, inputs.rig.joints, loudness().is_verbose) +
           next_step(request);
  }
  std::vector<io::FileContent> files;
  if (!request.excitation.empty()) {
    files.push_back(
        {request.excitation, identification::commands_csv(plan.motions, inputs.rig.joints)});
  }
  deliver(std::move(files), request.json ? text : for_window(text));
  return plan.tells_all() ? ExitCode::kPasses : ExitCode::kUndecided;
}

}  // namespace torquewright::cli
