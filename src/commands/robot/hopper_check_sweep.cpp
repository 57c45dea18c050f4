// SPDX-License-Identifier: Apache-2.0
#include "src/commands/robot/hopper_check_sweep.hpp"

#include <fmt/format.h>

#include <utility>

#include "io/faults/refusal.hpp"
#include "src/commands/robot/hopper_check_inputs.hpp"
#include "src/commands/robot/hopper_check_json.hpp"
#include "src/commands/robot/hopper_check_row.hpp"
#include "src/commands/robot/robot_sweep.hpp"
#include "src/interrupt.hpp"

namespace torquewright::cli {
namespace {

using hopper::Quantity;

/// Whether the motion asks other torques of other robots of the sweep.
bool changes_torques(const RobotSweep& asked) {
  return asked.has(Quantity::kMass) || asked.has(Quantity::kRatio);
}

/// What a file holds of torques and forces is of the robot as documented.
void take_from_dynamics(const RobotSweep& asked, hopper::Motion& motion,
                        hopper::CheckOptions& check) {
  if (!changes_torques(asked)) return;
  if (check.torques == hopper::TorqueSource::kFile) {
    io::refuse("--torques",
               "file: they are those of the rotors and masses of the documents, which the sweep "
               "changes");
  }
  if (!motion.has_base) {
    io::refuse("--sweep", fmt::format("{} does not say how the base moves: what another mass or "
                                      "ratio asks for is not known",
                                      motion.file));
  }
  check.torques = hopper::TorqueSource::kDynamics;
  if (asked.has(Quantity::kMass)) motion.has_forces = motion.forces_guide = false;
}

}  // namespace

ExitCode run_hopper_check_sweep(const HopperCheckRequest& request) {
  refuse_of_one_robot(*request.declared);
  const std::vector<std::filesystem::path> named_inputs{request.robot_file,
                                                        request.trajectory_file};
  require_sweep_outputs(request.sweep, request.output_file, named_inputs);
  HopperCheckRead read = read_inputs(request);
  const HopperCheckInputs& inputs = read.inputs;
  hopper::Motion& motion = read.motion;
  // Now that the robot's files are known.
  require_sweep_outputs(request.sweep, request.output_file, named_inputs);
  const hopper::Robot& robot = inputs.robot.robot;
  const RobotSweep asked = read_robot_sweep(request.sweep, robot, inputs.check.conditions);
  hopper::CheckOptions check = inputs.check;
  check.keep_traces = false;
  take_from_dynamics(asked, motion, check);
  catch_interrupt();
  const auto swept = run_robot_sweep(
      asked, robot, {"hopper check", hopper_check_fingerprint(request, inputs, motion)},
      request.sweep.points, request.output_file, [&](const hopper::Robot& varied) {
        hopper::Motion own = motion;  // the check adds the rates that it lacks
        return hopper_check_row(varied, check, hopper::check_motion(varied, own, check));
      });
  if (!swept) return ExitCode::kPasses;
  write_swept(*swept, request.sweep, request.output_file, request.json,
              hopper_check_sweep_json(request, inputs, motion, *swept));
  return code_of(*swept);
}

}  // namespace torquewright::cli
