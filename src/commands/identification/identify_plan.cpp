// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "actuator/motor/actuator_spec.hpp"
#include "identification/experiment/plan.hpp"
#include "io/documents/document.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/atomic_file.hpp"
#include "src/commands/identification/identify_commands.hpp"
#include "src/commands/identification/identify_plan_request.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/commands/shared/stated_json.hpp"
#include "src/options/noise_option.hpp"
#include "src/report/identification/plan_json.hpp"
#include "src/report/identification/plan_text.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

using identification::Plan;

struct PlanInputs {
  io::Document rig_document;
  identification::Rig rig;
  actuator::ReadActuator nominal;
  identification::PlanOptions options;
};

/// The documents that a plan is made from.
std::vector<io::Document> documents_of(const PlanInputs& inputs) {
  std::vector<io::Document> documents = inputs.nominal.documents;
  documents.push_back(inputs.rig_document);
  return documents;
}

PlanInputs read(const PlanRequest& request) {
  if (is_standard_output(request.excitation) && request.json) {
    io::refuse("--json", "standard output takes the excitation of -o -");
  }
  PlanInputs inputs;
  inputs.options = request.options;
  inputs.rig_document = io::read_document(request.rig, "rig");
  inputs.rig = identification::read_rig(inputs.rig_document);
  inputs.options.noise = read_noise(request.noise, inputs.rig);
  inputs.nominal = actuator::read_wound_actuator(request.actuator);
  if (request.excitation.empty()) return inputs;
  std::vector<std::filesystem::path> files;
  for (const io::Document& document : documents_of(inputs)) files.emplace_back(document.file);
  check_written({request.excitation}, files);
  return inputs;
}

std::string plan_document(const PlanRequest& request, const PlanInputs& inputs, const Plan& plan) {
  return result_text(report::plan_json(plan, stated_json(*request.declared)), documents_of(inputs));
}

void write(const PlanRequest& request, const PlanInputs& inputs, const Plan& plan) {
  std::vector<io::FileContent> files;
  std::string text =
      request.json ? plan_document(request, inputs, plan) : report::plan_text(plan, inputs.options);
  if (!request.excitation.empty()) {
    files.push_back({request.excitation, identification::excitation_csv(plan.runs)});
    if (!request.json) text += fmt::format("Written: {}\n", request.excitation);
  }
  deliver(std::move(files), request.json ? text : for_window(text));
}

bool is_of_robot(const PlanRequest& request) {
  if (!request.robot.empty()) return true;
  const io::Document rig = io::read_document(request.rig, "rig");
  return identification::read_rig(rig).load.type == identification::LoadType::kRobot;
}

/// Options that only one of both kinds of plan knows are not passed over.
void require_bench_options(const PlanRequest& request) {
  if (request.actuator.empty()) {
    command_line::refuse("actuator is required, for the rig moves no robot");
  }
  const auto refuse_given = [](bool is_given, const char* name) {
    if (is_given) io::refuse(name, "the rig moves no robot; leave the option out");
  };
  refuse_given(!request.of_joints.empty(), "--actuator");
  refuse_given(!request.posture.empty(), "--posture");
  refuse_given(request.base_height_m.has_value(), "--base-height");
}

ExitCode run_plan(const PlanRequest& request) {
  if (is_of_robot(request)) {
    if (!request.actuator.empty()) {
      io::refuse(request.actuator,
                 "the rig moves a robot, whose drives are its document's; --actuator JOINT=FILE "
                 "names another");
    }
    return run_robot_plan(request);
  }
  require_bench_options(request);
  const PlanInputs inputs = read(request);
  const Plan plan =
      identification::plan_excitation(inputs.rig, inputs.nominal.actuator, inputs.options);
  write(request, inputs, plan);
  return plan.is_separable() ? ExitCode::kPasses : ExitCode::kUndecided;
}

}  // namespace

void add_identify_plan(command_line::Command& identify) {
  auto request = std::make_shared<PlanRequest>();
  command_line::Command command =
      identify.add_command("plan", "Plan what to play, so that effects can be told apart");
  request->declared = &command.declared();
  command.add_option("actuator", request->actuator, "Document of kind actuator, as designed")
      .otherwise("the drives of the rig's robot");
  command
      .add_option("--rig", request->rig,
                  "Document of kind rig, which says what the load and the columns are")
      .required();
  command
      .add_option("--robot", request->robot,
                  "Document of kind robot, whose joints are to move while its base is held, where "
                  "the rig states no load")
      .otherwise("the rig's load");
  command
      .add_option(
          "--actuator", request->of_joints,
          "JOINT=FILE: a drive of the robot that differs from its document's, '*_knee=FILE' "
          "for many")
      .otherwise("the robot's own")
      .one_value_each();
  command
      .add_option("--posture", request->posture,
                  "Posture of the robot about which it moves, by its name")
      .otherwise("the one in which it stands, or the middle of its joints' ranges");
  command
      .add_option("--base-height", request->base_height_m,
                  "How high the origin of the robot's base hangs above the ground, in m")
      .otherwise("the ground is out of reach")
      .positive();
  command.add_option("--separate", request->options.separate, "Effects that are to be told apart")
      .otherwise("friction, saturation and inertia")
      .separated_by_commas();
  command
      .add_option("--duration", request->options.duration_s,
                  "How long all runs take together, in s; a number from 8 to 600")
      .always_stated_as("duration_s");
  command
      .add_option("--position-range", request->options.limits.position_rad,
                  "How far the output may move from where it starts, in rad")
      .otherwise("not limited")
      .positive();
  command
      .add_option("--speed-limit", request->options.limits.speed_rad_s,
                  "How fast the rig's output may turn, in rad/s")
      .otherwise("not limited")
      .positive();
  command
      .add_option(
          "--noise", request->noise,
          "QUANTITY=SIGMA: the white noise of a column has that standard deviation, in its unit")
      .otherwise("typical ones");
  command.add_option("--seed", request->options.seed, "Seed of the search")
      .always_stated_as("seed");
  command.add_option("-o,--output", request->excitation, "Write the excitation to this CSV")
      .names_a_file();
  command.add_flag("--json", request->json, "Print the plan as JSON");
  command.example(
      "torquewright identify plan specs/log/bench_actuator.json "
      "--rig specs/log/bench_rig.json --separate coulomb_friction,viscous_friction --duration 16");
  command.works([request] { return run_plan(*request); });
}

}  // namespace torquewright::cli
