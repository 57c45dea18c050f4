// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gearbox/problem_spec.hpp"
#include "gearbox/synthesis_defaults_spec.hpp"
#include "hopper/design/co_design_spec.hpp"
#include "io/documents/json_reader.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/nearest.hpp"
#include "src/commands/design/design_commands.hpp"
#include "src/commands/robot/hopper_check_inputs.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/interrupt.hpp"
#include "src/loudness.hpp"
#include "src/options/output_files.hpp"
#include "src/report/parts/progress_line.hpp"
#include "src/report/parts/shell_word.hpp"
#include "src/report/robot/co_design_text.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

/// What `design` is asked; the robot, the motion and how it is judged as in `hopper check`.
struct DesignRequest {
  HopperCheckRequest check;
  std::string drive;
  std::string motors;
  std::string problem_file;
  std::string ratios;
  std::int64_t points = 1;
  bool all_pairs = false;
  bool takes_load_of_motion = false;
  double time_limit_s = 0.0;
  int threads = 1;
  std::string actuators_folder;
  std::string output_file;
  bool all = false;
  bool json = false;
};

struct DesignInputs {
  HopperCheckRead check;
  io::Document problem_document;
  hopper::CoDesignQuestion question;
};

std::size_t drivetrain_of(const std::string& drive, const hopper::ReadRobot& read) {
  std::vector<std::string> names;
  const std::vector<hopper::Drivetrain>& drivetrains = read.robot.drivetrains;
  for (std::size_t i = 0; i < drivetrains.size(); ++i) {
    std::vector<std::string> own = drivetrains[i].actuator_names;
    for (const std::size_t joint : drivetrains[i].joints) {
      own.push_back(read.robot.tree.bodies[joint].joint.name);
    }
    if (std::find(own.begin(), own.end(), drive) != own.end()) return i;
    names.insert(names.end(), own.begin(), own.end());
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  if (names.empty()) io::refuse("--drive", "the robot has no drives");
  io::refuse("--drive", fmt::format("\"{}\" is not a drive of the robot; there are {}", drive,
                                    fmt::join(names, ", ")));
}

hopper::MotorShelf shelf_of(const DesignRequest& request, const hopper::ReadRobot& robot,
                            std::size_t drivetrain) {
  hopper::MotorShelf shelf = request.motors.empty() ? hopper::own_motor(robot, drivetrain)
                             : request.motors == "catalogue"
                                 ? hopper::motor_shelf(actuator::catalogue())
                                 : hopper::motor_shelf(actuator::drives_in(request.motors));
  if (shelf.motors.empty()) {
    io::refuse(request.motors.empty() ? "--motors" : request.motors,
               shelf.left_out.empty() ? "holds no motor" : shelf.left_out.front());
  }
  return shelf;
}

void require_friction(const gearbox::Problem& problem, const std::string& file) {
  if (problem.friction_coefficient) return;
  throw io::SpecError(
      {{file, "/friction_coefficient", "missing: the gears' efficiencies follow from it"}});
}

void require_folder(const std::string& folder) {
  std::error_code error;
  if (folder.empty() || std::filesystem::is_directory(folder, error)) return;
  io::refuse("--write", fmt::format("\"{}\" is no folder; make it first", folder));
}

DesignInputs read(const DesignRequest& request) {
  DesignInputs inputs{read_inputs(request.check), {}, {}};
  const hopper::ReadRobot& robot = inputs.check.inputs.robot;
  hopper::CoDesignQuestion& question = inputs.question;
  question.drivetrain = drivetrain_of(request.drive, robot);
  question.shelf = shelf_of(request, robot, question.drivetrain);
  inputs.problem_document = gearbox::read_problem_document(request.problem_file);
  question.problem = gearbox::read_open_problem(inputs.problem_document);
  require_friction(question.problem, request.problem_file);
  question.ratios = request.ratios.empty()
                        ? std::vector<io::Rational>{abs(question.problem.target_ratio)}
                        : hopper::read_ratios(request.ratios);
  question.points = static_cast<std::size_t>(request.points);
  question.prunes = !request.all_pairs;
  question.threads = static_cast<std::size_t>(request.threads);
  require_folder(request.actuators_folder);
  check_written(
      named({request.output_file}),
      named({request.check.robot_file, request.check.trajectory_file, request.problem_file}));
  return inputs;
}

/// Beside the motion's load gears turn their own inertia; and a load is stated as a whole number.
io::Rational load_with_room_Nm(double load_Nm) {
  constexpr double kRoom = 1.01;
  return std::max(1.0, std::ceil(kRoom * load_Nm));
}

void take_load_of_motion(const hopper::Robot& robot, const hopper::HopperReport& report,
                         hopper::CoDesignQuestion& question) {
  const double load_Nm = hopper::greatest_load_Nm(robot, question.drivetrain, report);
  question.problem.load_output_torque_Nm = load_with_room_Nm(load_Nm);
}

hopper::CoDesign compute(const DesignRequest& request, DesignInputs& inputs) {
  using Clock = std::chrono::steady_clock;
  catch_interrupt();
  report::ProgressLine line;
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(request.time_limit_s));
  const bool has_end = request.time_limit_s > 0.0;
  inputs.question.should_stop = [has_end, end] {
    return is_interrupted() || (has_end && Clock::now() >= end);
  };
  inputs.question.report = [&line](const std::string& what, std::size_t done, std::size_t all) {
    line.show(fmt::format("{}: {} of {}", what, done, all));
  };
  const HopperCheckInputs& read = inputs.check.inputs;
  const hopper::HopperReport report =
      hopper::check_motion(read.robot.robot, inputs.check.motion, read.check);
  if (request.takes_load_of_motion) {
    take_load_of_motion(read.robot.robot, report, inputs.question);
  }
  return hopper::co_design(read.robot.robot, inputs.check.motion, read.check, report,
                           inputs.question);
}

/// The motors behind their gears that do the motion, one file each.
std::vector<io::FileContent> actuator_files(const DesignRequest& request,
                                            const DesignInputs& inputs,
                                            const hopper::CoDesign& design) {
  std::vector<io::FileContent> files;
  if (request.actuators_folder.empty()) return files;
  for (const hopper::DesignedPair& pair : design.pairs) {
    if (pair.result.verdict != actuator::Verdict::kPass) continue;
    std::string name = fmt::format("{}_{:g}", inputs.question.shelf.motors[pair.motor].name,
                                   io::nearest(inputs.question.ratios[pair.ratio]));
    if (request.points > 1) name += fmt::format("_{}", pair.choice + 1);
    files.push_back({std::filesystem::path(request.actuators_folder) / (name + ".json"),
                     io::json_text(hopper::designed_actuator_json(inputs.question, design, pair))});
  }
  return files;
}

std::vector<io::Document> documents_of(const DesignInputs& inputs) {
  std::vector<io::Document> documents = inputs.check.inputs.robot.documents;
  documents.push_back(inputs.problem_document);
  documents.insert(documents.end(), inputs.question.shelf.documents.begin(),
                   inputs.question.shelf.documents.end());
  return documents;
}

std::string next_line(const DesignRequest& request, const hopper::CoDesign& design) {
  const bool found =
      !design.pairs.empty() && design.pairs.front().result.verdict == actuator::Verdict::kPass;
  if (!found) return "";
  if (request.actuators_folder.empty()) {
    return "next: the same with --write FOLDER, which writes these drives as documents\n";
  }
  return fmt::format("next: torquewright hopper check {} {} --candidates {}\n",
                     report::shell_word(request.check.robot_file),
                     report::shell_word(request.check.trajectory_file),
                     report::shell_word(request.actuators_folder));
}

ExitCode exit_code_of(const hopper::CoDesign& design) {
  const auto has = [&design](actuator::Verdict verdict) {
    return std::any_of(design.pairs.begin(), design.pairs.end(),
                       [verdict](const auto& pair) { return pair.result.verdict == verdict; });
  };
  if (!design.is_whole) return ExitCode::kUndecided;
  if (has(actuator::Verdict::kPass)) return ExitCode::kPasses;
  return has(actuator::Verdict::kUndecided) ? ExitCode::kUndecided : ExitCode::kFails;
}

ExitCode run_design(const DesignRequest& request) {
  DesignInputs inputs = read(request);
  const hopper::CoDesign design = compute(request, inputs);
  const hopper::Robot& robot = inputs.check.inputs.robot.robot;
  deliver_report(
      {result_text(hopper::co_design_json(robot, inputs.question, design), documents_of(inputs)),
       for_window(report::co_design_text(robot, inputs.question, design,
                                         request.all || loudness().is_verbose) +
                  next_line(request, design))},
      request.output_file, request.json, actuator_files(request, inputs, design));
  return exit_code_of(design);
}

void add_design_options(command_line::Command& command, DesignRequest& request) {
  command
      .add_option("--drive", request.drive,
                  "Which drive is designed: the name of its joint or of its actuator")
      .required();
  command
      .add_option("--gearbox", request.problem_file,
                  "Document of kind gearbox_problem, asked at every ratio")
      .required();
  command
      .add_option("--ratios", request.ratios,
                  "FROM:TO[:STEP], ratios at which the problem is asked")
      .otherwise("the problem's own");
  command
      .add_option("--motors", request.motors,
                  "Folder of actuators whose motors are tried; \"catalogue\" is that of "
                  "specs/catalogue, compiled in")
      .otherwise("the motor that the robot has there");
  command
      .add_option("--points", request.points,
                  "How many gearboxes of each ratio, on the front of the problem's objective "
                  "against forward efficiency")
      .otherwise("1, the best by the objective")
      .integer_between(1, 100);
  command.add_flag("--all-pairs", request.all_pairs,
                   "Search gears also for pairs that would fail with gears without losses");
  command.add_flag("--motion-load", request.takes_load_of_motion,
                   "Let the gears bear the greatest torque of the motion, not the problem's load");
  command.add_option("--time-limit", request.time_limit_s, "End the search after so many seconds")
      .otherwise("as long as it takes")
      .between(0.0, 1e9);
  command.add_option("--threads", request.threads, "How many threads search and try")
      .integer_between(1, 256);
  command
      .add_option("--write", request.actuators_folder,
                  "Write the drives that do the motion as actuators into this folder")
      .otherwise("none is written");
  command.add_option("-o,--output", request.output_file, "Write the answer as JSON to this file")
      .names_a_file();
  command.add_flag("--json", request.json, "Print the answer as JSON");
  command.add_flag("--all", request.all, "Print every pair, and what was left out")
      .excludes("--json");
}

}  // namespace

void add_design_command(command_line::Command& program) {
  auto request = std::make_shared<DesignRequest>();
  command_line::Command command =
      program.add_command("design", "Which motor behind which gears does the motion?");
  command.add_option("robot", request->check.robot_file, "Document of kind robot").required();
  command
      .add_option("trajectory", request->check.trajectory_file,
                  "CSV of the motion, as for hopper check")
      .required();
  request->check.declared = &command.declared();
  add_design_options(command, *request);
  add_motion_options(command, request->check);
  add_contact_options(command, request->check.check.contact);
  add_operating_options(command, request->check.operating);
  command.example(
      "torquewright design specs/robot/hopper.json specs/trajectory/hopper_squat.csv --drive knee "
      "--gearbox specs/gearbox/d151_knee.json");
  command.works([request] { return run_design(*request); });
}

}  // namespace torquewright::cli
