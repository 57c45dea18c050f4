// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>

#include "hopper/files/mjcf_writer.hpp"
#include "hopper/files/urdf_writer.hpp"
#include "hopper/robot/robot_spec.hpp"
#include "io/atomic_file.hpp"
#include "src/commands/robot_commands.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct ExportOptions {
  std::string robot_file;
  std::string format;
  std::string output_file;
};

ExitCode run_export(const ExportOptions& options) {
  if (!options.output_file.empty()) io::check_outputs({options.output_file}, {options.robot_file});
  const hopper::Robot robot = hopper::read_robot(options.robot_file).robot;
  const hopper::Exported exported =
      options.format == "urdf" ? hopper::urdf_of(robot) : hopper::mjcf_of(robot);
  if (options.output_file.empty()) {
    print_result(exported.text);
    return ExitCode::kPasses;
  }
  io::write_whole_file(options.output_file, exported.text);
  std::string said;
  for (const std::string& note : exported.notes) said += "note: " + note + "\n";
  print_result(said);
  return ExitCode::kPasses;
}

}  // namespace

void add_export_command(CLI::App& robot, ExitCode& result) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command = robot.add_subcommand("export", "URDF or MJCF out");
  command->add_option("robot", options->robot_file, "Document of kind robot")->required();
  command->add_option("--format", options->format, "urdf or mjcf")
      ->required()
      ->check(CLI::IsMember({"urdf", "mjcf"}));
  command->add_option("-o,--output", options->output_file, "Write to this file");
  command->footer("Example:\n  torquewright robot export specs/robot/hopper.json --format mjcf");
  command->callback([options, &result] { result = run_export(*options); });
}

}  // namespace torquewright::cli
