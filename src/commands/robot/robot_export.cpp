// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/library.hpp"
#include "actuator/exporters/text.hpp"
#include "hopper/randomised_files/drives_tolerances.hpp"
#include "hopper/randomised_files/event_file.hpp"
#include "hopper/trials/randomisation_spec.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/atomic_file.hpp"
#include "robot/mjcf/mjcf_writer.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/sdf/sdf_writer.hpp"
#include "robot/simulators/actuator_file.hpp"
#include "robot/simulators/drives_in_joints.hpp"
#include "robot/simulators/region_module_file.hpp"
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
  std::string randomisation_file;
  hopper::MjcfParts parts;
};

/// Null for files of bodies and joints, and for modules of regions.
const actuator::Exporter* actuators_only(const ExportOptions& options) {
  const actuator::Exporter* exporter = actuator::find_exporter(options.format);
  return exporter && exporter->write_all ? exporter : nullptr;
}

/// A module of Python around an MJCF.
bool is_module(const ExportOptions& options) { return options.format == "playground"; }

/// A file of bodies and joints whose drives are limits and friction of its joints.
struct JointFormat {
  std::string_view name;
  const actuator::Exporter* law;
  hopper::Exported (*write)(const hopper::Robot&, const hopper::DrivesInJoints&);
};

constexpr JointFormat kJointFormats[] = {
    {"urdf", &actuator::exporters::urdf, hopper::urdf_of},
    {"gazebo", &actuator::exporters::sdf,
     [](const hopper::Robot& robot, const hopper::DrivesInJoints& drives) {
       return hopper::sdf_of(robot, hopper::SdfReader::kGazebo, drives);
     }},
    {"drake", &actuator::exporters::drake_sdf,
     [](const hopper::Robot& robot, const hopper::DrivesInJoints& drives) {
       return hopper::sdf_of(robot, hopper::SdfReader::kDrake, drives);
     }},
};

const JointFormat* joint_format(const ExportOptions& options) {
  for (const JointFormat& format : kJointFormats) {
    if (format.name == options.format) return &format;
  }
  return nullptr;
}

bool holds_drives_alone(const ExportOptions& options) {
  return actuators_only(options) || hopper::find_region_module(options.format);
}

void require_friction(const ExportOptions& options) {
  const JointFormat* format = joint_format(options);
  if (options.friction == "joint" && format &&
      format->law->friction.dry == actuator::DryFriction::kNone) {
    io::refuse("--friction", fmt::format("joint, but joints of {} have no dry friction: say limits",
                                         options.format));
  }
}

void require_parts(const ExportOptions& options) {
  const hopper::MjcfParts& parts = options.parts;
  if (!options.randomisation_file.empty() && !hopper::find_event_writer(options.format)) {
    io::refuse("--randomise", fmt::format("{} has no form for it: these have: {}", options.format,
                                          fmt::join(hopper::randomised_formats(), ", ")));
  }
  const bool has_mjcf_parts =
      parts.servos || parts.ground || parts.collisions || parts.closed_loops;
  if (has_mjcf_parts && options.format != "mjcf" && !is_module(options)) {
    io::refuse("--format",
               "--servos, --ground, --collisions and --closed-loops are for mjcf and playground");
  }
  if (holds_drives_alone(options) && !parts.actuators) {
    io::refuse("--format",
               fmt::format("{} holds drives and nothing else: say --actuators", options.format));
  }
  require_friction(options);
}

/// Where a document's name would stand: ranges of the drives' own documents.
constexpr char kTolerances[] = "tolerances";

/// The robot, and what varies of it.
struct ExportInputs {
  hopper::ReadRobot robot;
  std::optional<hopper::Randomisation> randomisation;
};

std::optional<hopper::Randomisation> asked_randomisation(const ExportOptions& options,
                                                         const hopper::Robot& robot) {
  if (options.randomisation_file.empty()) return std::nullopt;
  if (options.randomisation_file != kTolerances) {
    return hopper::read_randomisation(options.randomisation_file).randomisation;
  }
  if (robot.drivetrains.empty()) {
    io::refuse("--randomise", "tolerances are of drives, and the robot has none");
  }
  return hopper::tolerances_of_drives(robot);
}

ExportInputs read(const ExportOptions& options) {
  require_parts(options);
  ExportInputs inputs{hopper::read_robot(options.robot_file), std::nullopt};
  hopper::ReadRobot& robot = inputs.robot;
  inputs.randomisation = asked_randomisation(options, robot.robot);
  if (inputs.randomisation) {
    hopper::require_fits(*inputs.randomisation, robot.robot);
    if (options.parts.servos && inputs.randomisation->bus_voltage_factor) {
      throw io::SpecError({{options.randomisation_file, "/bus_voltage_factor",
                            "with --servos controls are angles, and no voltage is there to vary: "
                            "leave the key or --servos out"}});
    }
  }
  const bool writes_drives =
      holds_drives_alone(options) || (joint_format(options) && options.parts.actuators);
  if (writes_drives && robot.robot.drivetrains.empty()) {
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
  return inputs;
}

/// The MJCF as a text of Python, under its name.
hopper::Exported module_of(hopper::Exported mjcf, const std::vector<std::string>& origin) {
  std::vector<std::string> head = origin;
  head.emplace_back("mujoco.MjModel.from_xml_string(MJCF), then mujoco.mjx.put_model(model).");
  mjcf.text = actuator::line_comment(head, "# ") + "MJCF = r\"\"\"" + mjcf.text + "\"\"\"\n";
  return mjcf;
}

hopper::Exported in_joints(const ExportOptions& options, const JointFormat& format,
                           const hopper::ReadRobot& read) {
  if (!options.parts.actuators) return format.write(read.robot, {});
  hopper::DrivesInJoints drives;
  const hopper::Robot driven =
      hopper::with_drives_in_joints(read.robot, *format.law, options.parts.friction, drives);
  return format.write(driven, drives);
}

hopper::Exported without_randomisation(const ExportOptions& options,
                                       const hopper::ReadRobot& read) {
  const std::vector<std::string> origin = origin_of("robot export", read.documents);
  if (const actuator::Exporter* exporter = actuators_only(options)) {
    return hopper::actuators_of(read.robot, *exporter, origin, options.parts.friction);
  }
  if (const hopper::RegionModule* module = hopper::find_region_module(options.format)) {
    return hopper::region_module_of(read.robot, *module, origin, options.parts.friction);
  }
  if (const JointFormat* format = joint_format(options)) return in_joints(options, *format, read);
  hopper::Exported mjcf = hopper::mjcf_of(read.robot, options.parts);
  return is_module(options) ? module_of(std::move(mjcf), origin) : mjcf;
}

hopper::Exported compute(const ExportOptions& options, const ExportInputs& inputs) {
  hopper::Exported exported = without_randomisation(options, inputs.robot);
  if (!inputs.randomisation) return exported;
  exported.text += hopper::events_of(*hopper::find_event_writer(options.format),
                                     *inputs.randomisation, inputs.robot.robot, exported.notes);
  return exported;
}

/// Files of bodies and joints, and every simulator that takes the drives of a robot in one file.
std::vector<std::string> export_formats() {
  std::vector<std::string> names{"mjcf", "playground"};
  for (const JointFormat& format : kJointFormats) names.emplace_back(format.name);
  for (const std::string_view name : hopper::region_module_formats()) names.emplace_back(name);
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
  write(options, compute(options, read(options)));
  return ExitCode::kPasses;
}

}  // namespace

void add_export_command(command_line::Command& robot) {
  auto options = std::make_shared<ExportOptions>();
  command_line::Command command = robot.add_command(
      "export",
      "Write a robot as URDF, SDF or MJCF (MuJoCo's XML), or its drives as a simulator's file");
  command.add_option("robot", options->robot_file, "Document of kind robot").required();
  command
      .add_option("--format", options->format,
                  "What is written: urdf, mjcf, gazebo and drake (SDF), playground (a module of "
                  "Python around an MJCF), or with --actuators genesis, pybullet and isaac-gym "
                  "(modules that hold the drives to their regions), isaac-lab, isaac-lab-2.3, "
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
  command
      .add_flag("--servos", options->parts.servos,
                "MJCF: drives are told angles (rad) in the place of voltages, as <position> with "
                "kp, kv and force range of their own inertia and torque")
      .needs("--actuators");
  command
      .add_option("--randomise", options->randomisation_file,
                  "Document of kind randomisation: write what it draws in the simulator's own form "
                  "behind the rest (isaac-lab, mjlab, playground, newton, genesis); or "
                  "tolerances: the motors' strengths that the drives' own documents leave open")
      .otherwise("nothing varies");
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
