// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>

#include "hopper/files/mjcf_writer.hpp"
#include "hopper/files/urdf_writer.hpp"
#include "hopper/robot/robot_spec.hpp"
#include "io/atomic_file.hpp"
#include "io/refusal.hpp"
#include "src/commands/robot_commands.hpp"
#include "src/options/output_files.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct ExportOptions {
  std::string robot_file;
  std::string format;
  std::string output_file;
  hopper::MjcfParts parts;
};

hopper::Robot read(const ExportOptions& options) {
  const hopper::MjcfParts& parts = options.parts;
  if (options.format == "urdf" &&
      (parts.actuators || parts.ground || parts.collisions || parts.closed_loops)) {
    io::refuse("--format", "--actuators, --ground, --collisions and --closed-loops are for mjcf");
  }
  hopper::Robot robot = hopper::read_robot(options.robot_file).robot;
  io::check_outputs(named({options.output_file}), {});
  return robot;
}

hopper::Exported compute(const ExportOptions& options, const hopper::Robot& robot) {
  return options.format == "urdf" ? hopper::urdf_of(robot) : hopper::mjcf_of(robot, options.parts);
}

void write(const ExportOptions& options, const hopper::Exported& exported) {
  deliver_result(exported.text, options.output_file);
  if (options.output_file.empty()) return;
  std::string said;
  for (const std::string& note : exported.notes) said += "note: " + note + "\n";
  print_result(said);
}

ExitCode run_export(const ExportOptions& options) {
  const hopper::Robot robot = read(options);
  write(options, compute(options, robot));
  return ExitCode::kPasses;
}

}  // namespace

void add_export_command(command_line::Command& robot) {
  auto options = std::make_shared<ExportOptions>();
  command_line::Command command = robot.add_command("export", "URDF or MJCF out");
  command.add_option("robot", options->robot_file, "Document of kind robot").required();
  command.add_option("--format", options->format, "urdf or mjcf")
      .required()
      .one_of({"urdf", "mjcf"});
  command.add_flag("--actuators", options->parts.actuators,
                   "MJCF: each drive's torque and speed limits, its control the voltage");
  command.add_flag("--ground", options->parts.ground,
                   "MJCF: a plane, and keyframes of the postures standing on it");
  command.add_flag("--collisions", options->parts.collisions,
                   "MJCF: shapes at contact points and collision spheres");
  command.add_flag("--closed-loops", options->parts.closed_loops,
                   "MJCF: cranks and rods of linkages as bodies, their loops closed by <connect>");
  command.add_option("-o,--output", options->output_file, "Write to this file").names_a_file();
  command.example("torquewright robot export specs/robot/hopper.json --format mjcf");
  command.works([options] { return run_export(*options); });
}

}  // namespace torquewright::cli
