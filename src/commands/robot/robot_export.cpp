// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "actuator/exporters/library.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/atomic_file.hpp"
#include "robot/mjcf/mjcf_writer.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/simulators/actuator_file.hpp"
#include "robot/urdf/urdf_writer.hpp"
#include "src/commands/robot/robot_commands.hpp"
#include "src/commands/shared/origin_lines.hpp"
#include "src/options/operating_options.hpp"
#include "src/options/output_files.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

struct ExportOptions {
  std::string robot_file;
  std::string format;
  std::string output_file;
  std::string friction;  ///< Empty: nobody said.
  hopper::MjcfParts parts;
};

/// Null for files of bodies and joints.
const actuator::Exporter* actuators_only(const ExportOptions& options) {
  const actuator::Exporter* exporter = actuator::find_exporter(options.format);
  return exporter && exporter->write_all ? exporter : nullptr;
}

void require_parts(const ExportOptions& options) {
  const hopper::MjcfParts& parts = options.parts;
  const bool has_mjcf_parts = parts.ground || parts.collisions || parts.closed_loops;
  if (actuators_only(options)) {
    if (has_mjcf_parts) {
      io::refuse("--format", "--ground, --collisions and --closed-loops are for mjcf");
    }
    if (!parts.actuators) {
      io::refuse("--format",
                 fmt::format("{} holds drives and nothing else: say --actuators", options.format));
    }
  } else if (options.format == "urdf" && (parts.actuators || has_mjcf_parts)) {
    io::refuse("--format", "--actuators, --ground, --collisions and --closed-loops are for mjcf");
  }
}

hopper::ReadRobot read(const ExportOptions& options) {
  require_parts(options);
  hopper::ReadRobot robot = hopper::read_robot(options.robot_file);
  if (actuators_only(options) && robot.robot.drivetrains.empty()) {
    throw io::SpecError({{options.robot_file, "/mechanisms",
                          "missing: there are no drives; `torquewright robot attach ROBOT "
                          "'JOINT=ACTUATOR' -o ROBOT` names them"}});
  }
  if (options.parts.actuators) {
    for (const hopper::Drivetrain& drivetrain : robot.robot.drivetrains) {
      for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i) {
        require_possible(drivetrain.actuators[i], drivetrain.actuator_files[i], {});
      }
    }
  }
  check_written(named({options.output_file}), {});
  return robot;
}

hopper::Exported compute(const ExportOptions& options, const hopper::ReadRobot& read) {
  if (const actuator::Exporter* exporter = actuators_only(options)) {
    return hopper::actuators_of(read.robot, *exporter, origin_of("robot export", read.documents),
                                options.parts.friction);
  }
  return options.format == "urdf" ? hopper::urdf_of(read.robot)
                                  : hopper::mjcf_of(read.robot, options.parts);
}

/// mjcf, urdf, and every simulator that takes the drives of a robot in one file.
std::vector<std::string> export_formats() {
  std::vector<std::string> names{"urdf", "mjcf"};
  for (const actuator::Exporter* exporter : actuator::exporter_library()) {
    if (exporter->write_all) names.emplace_back(exporter->name);
  }
  return names;
}

void write(const ExportOptions& options, const hopper::Exported& exported) {
  deliver_result(exported.text, options.output_file);
  if (options.output_file.empty() || is_standard_output(options.output_file)) return;
  std::string said;
  for (const std::string& note : exported.notes) said += "note: " + note + "\n";
  print_result(for_window(said));
}

ExitCode run_export(const ExportOptions& options) {
  const hopper::ReadRobot robot = read(options);
  write(options, compute(options, robot));
  return ExitCode::kPasses;
}

}  // namespace

void add_export_command(command_line::Command& robot) {
  auto options = std::make_shared<ExportOptions>();
  command_line::Command command = robot.add_command(
      "export",
      "Write a robot as URDF or MJCF (MuJoCo's XML), or all its drives as a simulator's file");
  command.add_option("robot", options->robot_file, "Document of kind robot").required();
  command
      .add_option("--format", options->format,
                  "What is written: urdf, mjcf, or with --actuators isaac-lab, "
                  "isaac-lab-remotized, mjlab or newton")
      .required()
      .one_of(export_formats());
  command.add_flag(
      "--actuators", options->parts.actuators,
      "Write every drive's torque and speed limits; in MJCF its control is the voltage");
  command
      .add_option("--friction", options->friction,
                  "Where drives have friction: joint (in the fields of the simulator's joint; in "
                  "MJCF of the tendon, where a drive turns several) or limits (taken off the "
                  "torque limits)")
      .otherwise("joint")
      .one_of({"joint", "limits"})
      .needs("--actuators");
  command.add_flag("--ground", options->parts.ground,
                   "MJCF: add a plane, and keyframes of the postures standing on it");
  command.add_flag("--collisions", options->parts.collisions,
                   "MJCF: add shapes at contact points and collision spheres");
  command.add_flag(
      "--closed-loops", options->parts.closed_loops,
      "MJCF: write cranks and rods of linkages as bodies, whose loops <connect> closes");
  command.add_option("-o,--output", options->output_file, "Write it to this file")
      .otherwise("-, standard output")
      .names_a_file();
  command.example("torquewright robot export specs/robot/hopper.json --format mjcf");
  command.example(
      "torquewright robot export specs/robot/cassie.json --format isaac-lab --actuators");
  command.works([options] {
    if (options->friction == "limits") options->parts.friction = actuator::FrictionPlace::kLimits;
    return run_export(*options);
  });
}

}  // namespace torquewright::cli
