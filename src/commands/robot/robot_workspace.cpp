// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "io/faults/refusal.hpp"
#include "io/text/wording.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/model/workspace.hpp"
#include "src/commands/robot/robot_commands.hpp"
#include "src/report/parts/gnuplot.hpp"
#include "src/report/robot/workspace_plot.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

constexpr int kSteps = 80;  // of each joint: a degree of the hopper's ankle

struct WorkspaceOptions {
  std::string robot_file;
  std::string joint;
  std::string plot_file;
};

bool moves_two(const hopper::Drivetrain& drivetrain) { return drivetrain.joints.size() == 2; }

bool moves(const hopper::Robot& robot, const hopper::Drivetrain& drivetrain,
           const std::string& joint) {
  return std::any_of(drivetrain.joints.begin(), drivetrain.joints.end(),
                     [&](std::size_t body) { return robot.tree.bodies[body].joint.name == joint; });
}

void require_ranges(const hopper::Robot& robot, const hopper::Drivetrain& drivetrain) {
  for (const std::size_t body : drivetrain.joints) {
    const dynamics::Joint& joint = robot.tree.bodies[body].joint;
    if (std::isfinite(joint.limits.position_min) && std::isfinite(joint.limits.position_max) &&
        joint.kind == dynamics::JointKind::kRevolute) {
      continue;
    }
    io::refuse(joint.name, "needs a range_rad, over which the workspace is looked at");
  }
}

/// The one that moves the joint that is asked for, else the only one of two joints.
const hopper::Drivetrain& chosen(const hopper::Robot& robot, const WorkspaceOptions& options) {
  std::vector<const hopper::Drivetrain*> found;
  std::vector<std::string> joints;
  for (const hopper::Drivetrain& drivetrain : robot.drivetrains) {
    if (!moves_two(drivetrain)) continue;
    joints.push_back(robot.tree.bodies[drivetrain.joints.front()].joint.name);
    if (options.joint.empty() || moves(robot, drivetrain, options.joint)) {
      found.push_back(&drivetrain);
    }
  }
  if (joints.empty()) {
    io::refuse(
        options.robot_file,
        "has no mechanism that moves two joints: where a joint alone can stand is its range_rad");
  }
  if (found.size() == 1) return *found.front();
  io::refuse("--joint", options.joint.empty()
                            ? fmt::format("which of {}?", io::either(joints))
                            : fmt::format("\"{}\" is moved by no mechanism of two joints; {} are",
                                          options.joint, io::listed(joints)));
}

ExitCode run_workspace(const WorkspaceOptions& options) {
  if (!options.plot_file.empty()) (void)report::plot_format(options.plot_file);
  const hopper::Robot robot = hopper::read_robot(options.robot_file).robot;
  const hopper::Drivetrain& drivetrain = chosen(robot, options);
  require_ranges(robot, drivetrain);
  const hopper::Workspace workspace = hopper::workspace_of(robot, drivetrain, kSteps);
  if (!options.plot_file.empty()) {
    const std::string title =
        fmt::format("{}: {} of {} and {}", robot.name, drivetrain.mechanism->type(),
                    workspace.joints[0], workspace.joints[1]);
    report::draw_with_gnuplot(
        report::workspace_plot(report::plot_format(options.plot_file), title, workspace),
        options.plot_file);
  }
  print_result(for_window(report::workspace_text(workspace)));
  return ExitCode::kPasses;
}

}  // namespace

void add_workspace_command(command_line::Command& robot) {
  auto options = std::make_shared<WorkspaceOptions>();
  command_line::Command command =
      robot.add_command("workspace",
                        "Where a mechanism of two joints can stand, within their ranges and "
                        "beyond, and what keeps it "
                        "from the rest");
  command.add_option("robot", options->robot_file, "Document of kind robot").required();
  command.add_option("--joint", options->joint, "A joint that the mechanism moves")
      .otherwise("the only mechanism of two joints");
  command.add_option("--plot", options->plot_file, "Draw it to this file, .svg or .png")
      .otherwise("none")
      .names_a_file();
  command.example("torquewright robot workspace specs/robot/hopper.json --plot ankle.svg");
  command.works([options] { return run_workspace(*options); });
}

}  // namespace torquewright::cli
