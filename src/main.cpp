// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "io/atomic_file.hpp"
#include "io/provenance.hpp"
#include "io/spec_error.hpp"
#include "src/commands/actuator_commands.hpp"
#include "src/commands/gearbox_commands.hpp"
#include "src/commands/hopper_commands.hpp"
#include "src/commands/identify_commands.hpp"
#include "src/commands/robot_commands.hpp"
#include "src/exit_code.hpp"

namespace {

using torquewright::cli::ExitCode;

int as_int(ExitCode code) { return static_cast<int>(code); }

[[noreturn]] void refuse_command_line(const CLI::ParseError& error) {
  throw torquewright::io::SpecError(
      {{"command line", "", std::string(error.what()) + "; --help shows what is allowed"}});
}

int run(int argc, char** argv) {
  CLI::App app{"Design tool for actuators and gearboxes of jumping robots", "torquewright"};
  app.set_version_flag("--version", std::string(torquewright::io::tool_version()));
  app.require_subcommand(1);
  app.footer("Example:\n  torquewright gearbox optimize specs/gearbox/d151_knee.json");
  ExitCode result = ExitCode::kPasses;
  CLI::App* gearbox = app.add_subcommand("gearbox", "Which teeth?");
  gearbox->require_subcommand(1);
  gearbox->footer(
      "Example:\n  torquewright gearbox optimize specs/gearbox/d110a_ankle.json --top 3");
  torquewright::cli::add_optimize_command(*gearbox, result);
  torquewright::cli::add_evaluate_command(*gearbox, result);
  torquewright::cli::add_verify_command(*gearbox, result);
  torquewright::cli::add_strength_command(*gearbox, result);
  CLI::App* actuator = app.add_subcommand("actuator", "What can the actuator do?");
  actuator->require_subcommand(1);
  actuator->footer(
      "Example:\n  torquewright actuator mor specs/actuator/d110a_ankle.json --need 100@15");
  torquewright::cli::add_lint_command(*actuator, result);
  torquewright::cli::add_mor_command(*actuator, result);
  torquewright::cli::add_check_command(*actuator, result);
  torquewright::cli::add_identify_command(app, result);
  CLI::App* hopper = app.add_subcommand("hopper", "Can it do the motion?");
  hopper->require_subcommand(1);
  hopper->footer(
      "Example:\n  torquewright hopper check specs/robot/hopper.json "
      "specs/trajectory/hopper_flip.csv");
  torquewright::cli::add_hopper_check_command(*hopper, result);
  torquewright::cli::add_calibrate_command(*hopper, result);
  CLI::App* robot = app.add_subcommand("robot", "Robots from and for other programs");
  robot->require_subcommand(1);
  robot->footer("Example:\n  torquewright robot export specs/robot/rabbit.json --format urdf");
  torquewright::cli::add_import_command(*robot, result);
  torquewright::cli::add_export_command(*robot, result);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // --help and --version come this way too, with exit code 0.
    if (error.get_exit_code() == 0) return app.exit(error);
    refuse_command_line(error);
  }
  return as_int(result);
}

}  // namespace

int main(int argc, char** argv) {
  torquewright::io::ignore_file_size_signal();
  try {
    return run(argc, argv);
  } catch (const torquewright::io::SpecError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return as_int(ExitCode::kBadInput);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "internal error: %s\n", error.what());
    return 70;  // EX_SOFTWARE: no statement about the input
  }
}
