// SPDX-License-Identifier: Apache-2.0
#include "src/program.hpp"

#include <string>

#include "io/documents/provenance.hpp"
#include "src/command_line/command_line.hpp"
#include "src/commands/actuator/actuator_commands.hpp"
#include "src/commands/design/design_commands.hpp"
#include "src/commands/gearbox/gearbox_commands.hpp"
#include "src/commands/identification/identify_commands.hpp"
#include "src/commands/policy/policy_commands.hpp"
#include "src/commands/robot/hopper_commands.hpp"
#include "src/commands/robot/robot_commands.hpp"
#include "src/commands/shared/help_commands.hpp"
#include "src/commands/shared/schema_commands.hpp"

namespace torquewright::cli {
namespace {

using command_line::Command;

/// A command that only leads to those that are added to it.
Command add_group(Command& program, const std::string& name, const std::string& question,
                  const std::string& example) {
  Command group = program.add_command(name, question);
  group.require_command();
  group.example("torquewright " + example);
  return group;
}

void add_gearbox_commands(Command& program) {
  Command gearbox = add_group(program, "gearbox", "Which teeth?",
                              "gearbox optimize specs/gearbox/d110a_ankle.json --top 3");
  add_optimize_command(gearbox);
  add_evaluate_command(gearbox);
  add_verify_command(gearbox);
  add_strength_command(gearbox);
  add_pareto_command(gearbox);
  add_drawing_command(gearbox);
  add_tolerances_command(gearbox);
}

void add_actuator_commands(Command& program) {
  Command actuator = add_group(program, "actuator", "What can the actuator do?",
                               "actuator mor specs/actuator/d110a_ankle.json --need 100@15");
  add_find_command(actuator);
  add_lint_command(actuator);
  add_mor_command(actuator);
  add_check_command(actuator);
}

void add_hopper_commands(Command& program) {
  Command hopper =
      add_group(program, "hopper", "Can it do the motion?",
                "hopper check specs/robot/hopper.json specs/trajectory/hopper_flip.csv");
  add_hopper_check_command(hopper);
  add_flip_command(hopper);
  add_replay_command(hopper);
  add_train_command(hopper);
  add_calibrate_command(hopper);
}

void add_policy_commands(Command& program) {
  Command policy = add_group(program, "policy", "Take a learned policy to the robot, or here",
                             "policy export specs/policy/upright.json --format c");
  add_policy_export_command(policy);
  add_policy_import_command(policy);
}

void add_robot_commands(Command& program) {
  Command robot = add_group(program, "robot",
                            "Any robot: can it do a motion, and how do other programs read it?",
                            "robot export specs/robot/rabbit.json --format urdf");
  add_hopper_check_command(robot);
  add_replay_command(robot);
  add_attach_command(robot);
  add_import_command(robot);
  add_patch_command(robot);
  add_export_command(robot);
  add_workspace_command(robot);
}

}  // namespace

ExitCode run_program(int argc, const char* const* argv) {
  command_line::Program program("torquewright",
                                "Design tool for actuators and gearboxes of jumping robots",
                                std::string(io::tool_version()));
  Command& top = program.top();
  top.require_command();
  top.example("torquewright gearbox optimize specs/gearbox/d151_knee.json");
  add_gearbox_commands(top);
  add_actuator_commands(top);
  add_design_command(top);
  add_identify_command(top);
  add_hopper_commands(top);
  add_policy_commands(top);
  add_robot_commands(top);
  add_init_command(top);
  add_schema_command(top);
  add_help_command(top);
  add_man_command(top);
  add_completion_command(top);
  return program.run(argc, argv);
}

}  // namespace torquewright::cli
