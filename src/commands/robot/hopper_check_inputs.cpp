// SPDX-License-Identifier: Apache-2.0
#include "src/commands/robot/hopper_check_inputs.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hopper/motion/further_hops.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/wording.hpp"
#include "robot/draft/limit_drives.hpp"
#include "src/report/parts/progress_line.hpp"

namespace torquewright::cli {
namespace {

hopper::TorqueSource torque_source(const std::string& name) {
  if (name == "file") return hopper::TorqueSource::kFile;
  return name == "dynamics" ? hopper::TorqueSource::kDynamics : hopper::TorqueSource::kBest;
}

hopper::LateRows late_rows(const std::string& name) {
  if (name == "keep") return hopper::LateRows::kKeep;
  return name == "shift" ? hopper::LateRows::kShift : hopper::LateRows::kFind;
}

/// Whether a state of charge is asked for that the battery cannot be at.
bool lacks_charge_curve(const actuator::Actuator& actuator,
                        const actuator::OperatingConditions& conditions) {
  return conditions.state_of_charge &&
         (!actuator.battery || actuator.battery->cell_open_circuit.size() < 2);
}

/// Torques of a file count where it has those of all driven joints.
void require_all_torques(const hopper::Robot& robot, const hopper::Motion& motion,
                         hopper::TorqueSource source) {
  if (source == hopper::TorqueSource::kDynamics) return;
  std::vector<std::string> there;
  std::vector<std::string> missing;
  for (const hopper::Drivetrain& drivetrain : robot.drivetrains) {
    for (const std::size_t body : drivetrain.joints) {
      (motion.has_effort[body - 1] ? there : missing).push_back(robot.tree.bodies[body].joint.name);
    }
  }
  if (there.empty() || missing.empty()) return;
  io::refuse(
      motion.file,
      fmt::format("has torques of {} and none of {}: those of some driven joints alone would "
                  "not count; give all, or --torques dynamics, which takes none of them",
                  io::listed(there), io::listed(missing)));
}

hopper::CandidateSet candidate_set_of(const HopperCheckRequest& request,
                                      const hopper::ReadRobot& robot) {
  if (request.candidates_folder.empty()) {
    if (!request.ratios.empty()) io::refuse("--ratios", "is for --candidates");
    return {};
  }
  std::optional<hopper::RatioSweep> sweep;
  if (!request.ratios.empty()) sweep = hopper::read_ratio_sweep(request.ratios);
  if (request.candidates_folder == "catalogue") return hopper::catalogue_candidates(robot, sweep);
  return hopper::read_candidate_set(request.candidates_folder, robot, sweep);
}

}  // namespace

hopper::MotionFile motion_file(const HopperCheckRequest& request) {
  hopper::MotionFile source;
  source.file = request.trajectory_file;
  source.mappings = request.columns;
  for (const std::string& file : request.columns_files) {
    source.documents.push_back(io::read_document(file, "trajectory_columns"));
  }
  source.window = window_of(request.window);
  source.bare = request.bare;
  return source;
}

hopper::CheckOptions check_options(const HopperCheckRequest& request,
                                   const hopper::ReadRobot& read) {
  hopper::CheckOptions check = request.check;
  check.conditions = stated_conditions(request.operating);
  for (const hopper::Drivetrain& drivetrain : read.robot.drivetrains) {
    for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i) {
      const bool is_robots = lacks_charge_curve(drivetrain.actuators[i], check.conditions) &&
                             drivetrain.on_robots_battery[i];
      require_possible(drivetrain.actuators[i],
                       is_robots ? request.robot_file : drivetrain.actuator_files[i],
                       check.conditions);
    }
  }
  check.torques = torque_source(request.torques);
  check.late_columns = late_rows(request.late_columns);
  check.keep_traces = !request.plot_file.empty() || !request.report_file.empty();
  return check;
}

hopper::Motion motion_in(hopper::MotionFile source, const hopper::Robot& robot) {
  report::ProgressLine progress;
  source.on_progress = [&progress](double share) {
    progress.show(fmt::format("reading the motion: {:.0f} %", 100.0 * share));
  };
  return hopper::read_motion(robot, source);
}

HopperCheckRead read_inputs(const HopperCheckRequest& request) {
  HopperCheckRead read;
  HopperCheckInputs& inputs = read.inputs;
  inputs.robot = hopper::read_robot(request.robot_file);
  hopper::drive_by_limits(inputs.robot.robot);
  const hopper::MotionFile source = motion_file(request);
  inputs.columns = source.documents;
  inputs.check = check_options(request, inputs.robot);
  read.motion = motion_in(source, inputs.robot.robot);
  if (request.hops > 0) {
    read.motion = hopper::with_flights(inputs.robot.robot, std::move(read.motion), request.hops);
  }
  require_all_torques(inputs.robot.robot, read.motion, inputs.check.torques);
  inputs.candidates = candidate_set_of(request, inputs.robot);
  return read;
}

}  // namespace torquewright::cli
