// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/faults/refusal.hpp"
#include "io/files/given_once.hpp"
#include "io/text/one_line.hpp"
#include "robot/draft/attached_drives.hpp"
#include "robot/model/robot_spec.hpp"
#include "src/commands/robot/robot_attach_json.hpp"
#include "src/commands/robot/robot_commands.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/options/output_files.hpp"
#include "src/report/parts/shell_word.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

struct AttachOptions {
  std::string robot_file;
  std::vector<std::string> drives;  ///< PATTERN=FILE.
  std::string output_file;
};

/// Where the document will be; on standard output, beside the robot.
std::filesystem::path new_place_of(const AttachOptions& options) {
  const bool is_file = !options.output_file.empty() && !is_standard_output(options.output_file);
  return std::filesystem::absolute(is_file ? options.output_file : options.robot_file);
}

std::vector<hopper::DrivePattern> patterns_of(const AttachOptions& options) {
  io::require_each_once("drives", options.drives);
  const std::filesystem::path folder = new_place_of(options).parent_path();
  std::vector<hopper::DrivePattern> patterns;
  for (const std::string& text : options.drives) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
      io::refuse(text,
                 "must be JOINT=ACTUATOR, a joint's name or a pattern with * and the file of "
                 "its drive: '*_calf_joint=calf.json'");
    }
    const auto file = std::filesystem::absolute(text.substr(equals + 1));
    patterns.push_back(
        {text.substr(0, equals), std::filesystem::proximate(file, folder).generic_string()});
  }
  return patterns;
}

std::string table_of(const std::vector<hopper::AttachedDrive>& attached) {
  std::size_t longest = 0;
  for (const hopper::AttachedDrive& each : attached) longest = std::max(longest, each.joint.size());
  std::string text;
  for (const hopper::AttachedDrive& each : attached) {
    text +=
        fmt::format("  {:<{}}  {}{}\n", io::one_line(each.joint), longest, io::one_line(each.file),
                    each.is_replaced ? ", in the place of another" : "");
  }
  return text;
}

/// Files of simulators state armature, of the drives that the robot had.
std::string rotor_note(const std::string& document,
                       const std::vector<hopper::AttachedDrive>& attached) {
  const std::size_t count = count_own_rotors(document, attached);
  if (count == 0) return "";
  return fmt::format(
      "note: {} of these joints state reflected_inertia_kg_m2, which holds in the place of their "
      "drives' rotors; take it out where it is of another drive\n",
      count);
}

ExitCode run_attach(const AttachOptions& options) {
  const hopper::ReadRobot read = hopper::read_robot(options.robot_file);
  const auto attached = hopper::attached_drives(read.robot, patterns_of(options));
  check_written(named({options.output_file}), {});
  const std::string document =
      robot_with_drives(options.robot_file, new_place_of(options), attached);
  // The drives' own documents may be at fault, or turn no such joint.
  (void)hopper::robot_of(
      io::check_document(as_read(document), "robot", new_place_of(options).string(), ""));
  deliver_result(document, options.output_file);
  if (options.output_file.empty() || is_standard_output(options.output_file)) {
    return ExitCode::kPasses;
  }
  print_result(for_window(
      fmt::format("{}{}\nnext: torquewright robot export {} --format isaac-lab --actuators\n",
                  table_of(attached), rotor_note(document, attached),
                  report::shell_word(options.output_file))));
  return ExitCode::kPasses;
}

}  // namespace

void add_attach_command(command_line::Command& robot) {
  auto options = std::make_shared<AttachOptions>();
  command_line::Command command =
      robot.add_command("attach", "Name the drives of a robot's joints, many by one pattern");
  command.add_option("robot", options->robot_file, "Document of kind robot").required();
  command
      .add_option("drives", options->drives,
                  "JOINT=ACTUATOR, a joint's name and its actuator's file; in a name * stands for "
                  "any letters: '*_calf_joint=calf.json'")
      .required();
  command.add_option("-o,--output", options->output_file, "Write the robot's document to this file")
      .otherwise("-, standard output")
      .names_a_file();
  command.example(
      "torquewright robot attach specs/robot/planar_leg.json knee=specs/actuator/d151_knee.json -o "
      "leg.json");
  command.works([options] { return run_attach(*options); });
}

}  // namespace torquewright::cli
