// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "actuator/motor/actuator_spec.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/atomic_file.hpp"
#include "io/files/file_bytes.hpp"
#include "io/files/given_once.hpp"
#include "robot/simulators/patched_file.hpp"
#include "robot/xml/element.hpp"
#include "src/commands/robot/robot_commands.hpp"
#include "src/options/output_files.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

struct PatchOptions {
  std::string robot_file;
  std::vector<std::string> drives;  ///< PATTERN=FILE.
  std::string output_file;
};

hopper::PatchedDrive drive_of(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
    io::refuse(text,
               "must be JOINT=ACTUATOR, a joint's name or a pattern with * and the file of its "
               "drive: '*_calf_joint=calf.json'");
  }
  const std::string file = text.substr(equals + 1);
  return {text.substr(0, equals),
          hopper::drive_numbers(actuator::read_actuator(file).actuator, file)};
}

std::string numbers_line(const hopper::PatchedDrive& drive) {
  const hopper::DriveNumbers& numbers = drive.numbers;
  std::string line =
      fmt::format("  {}: {:.6g} Nm at rest, drives to {:.6g} rad/s, rotor {:.6g} kg m2",
                  drive.pattern, numbers.torque_Nm, numbers.speed_rad_s, numbers.armature_kg_m2);
  if (numbers.friction) {
    line += fmt::format("; friction {:.6g} Nm and {:.6g} Nm s/rad", numbers.friction->coulomb_Nm,
                        numbers.friction->viscous_Nm_s_rad);
  }
  return line + "\n";
}

std::string next_line(const PatchOptions& options) {
  if (!options.output_file.empty()) return "";
  return "next: the same with -o FILE, which writes it\n";
}

ExitCode run_patch(const PatchOptions& options) {
  io::require_each_once("drives", options.drives);
  (void)hopper::read_element(options.robot_file);  // refuses what is no XML, with its line
  const std::string before = io::read_file_bytes(options.robot_file);
  std::vector<hopper::PatchedDrive> drives;
  for (const std::string& text : options.drives) drives.push_back(drive_of(text));
  const hopper::PatchedFile patched = hopper::patched_file(options.robot_file, before, drives);
  check_written(named({options.output_file}), {options.robot_file});
  const std::size_t count = patched.joints.size();
  std::string text = fmt::format("{}: {} {}\n", options.robot_file, count,
                                 count == 1 ? "joint changes" : "joints change");
  for (const hopper::PatchedDrive& each : drives) text += numbers_line(each);
  text += hopper::line_difference(before, patched.text);
  for (const std::string& note : patched.notes) text += "note: " + note + "\n";
  std::vector<io::FileContent> files;
  if (!options.output_file.empty()) files.push_back({options.output_file, patched.text});
  deliver(std::move(files), for_window(text + next_line(options)));
  return ExitCode::kPasses;
}

}  // namespace

void add_patch_command(command_line::Command& robot) {
  auto options = std::make_shared<PatchOptions>();
  command_line::Command command = robot.add_command(
      "patch", "Write drives' numbers into your own URDF or MJCF, and keep every other byte");
  command.add_option("file", options->robot_file, "The robot's URDF or MJCF")
      .required()
      .existing_file();
  command
      .add_option("drives", options->drives,
                  "JOINT=ACTUATOR, a joint's name and its actuator's file; in a name * stands for "
                  "any letters: '*_calf_joint=calf.json'")
      .required();
  command
      .add_option("-o,--output", options->output_file,
                  "Write the patched file to this file; the lines that change are printed anyway")
      .otherwise("nothing is written")
      .names_a_file();
  command.example(
      "torquewright robot patch specs/robot/rabbit.urdf "
      "left_knee=specs/actuator/d151_knee.json");
  command.works([options] { return run_patch(*options); });
}

}  // namespace torquewright::cli
