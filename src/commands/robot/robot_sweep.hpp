// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "actuator/region/operating_conditions.hpp"
#include "hopper/variation/variation.hpp"
#include "src/exit_code.hpp"
#include "src/options/sweep_options.hpp"
#include "src/sweep/grid.hpp"
#include "src/sweep/swept.hpp"

namespace torquewright::cli {

/// Which of a robot's quantities take which values.
struct RobotSweep {
  sweep::Grid grid;
  std::vector<hopper::Variable> variables;  ///< One an axis.

  bool has(hopper::Quantity quantity) const;
};

/// Throws io::SpecError: no such quantity, a value that cannot be, two that are one, a voltage that
/// the conditions set.
RobotSweep read_robot_sweep(const SweepOptions& options, const hopper::Robot& robot,
                            const actuator::OperatingConditions& conditions);

/// The robot of a point.
hopper::Robot robot_at(const RobotSweep& swept, const hopper::Robot& robot, std::size_t point);

/// What a point's answer depends on beside the robot's values.
struct SweepIdentity {
  std::string command;      ///< "hopper check"
  std::string fingerprint;  ///< SHA-256 of options and inputs.
};

/// Called in a worker process. What it throws as io::SpecError is a row too: refused.
using EvaluateRobot = std::function<sweep::SweepRow(const hopper::Robot& robot)>;

/// Evaluates every point (sweep::run_sweep). None in a worker, which ends without a word.
std::optional<sweep::Swept> run_robot_sweep(const RobotSweep& asked, const hopper::Robot& robot,
                                            const SweepIdentity& identity,
                                            const PointOptions& points,
                                            const std::string& output_file,
                                            const EvaluateRobot& evaluate);

/// Some point passes; none does; not all points are done, or none passes and some are open.
ExitCode code_of(const sweep::Swept& swept);

/// Checks before the work: throws io::SpecError where a file of the sweep's cannot be written or
/// drawn.
void require_sweep_outputs(const SweepOptions& options, const std::string& output_file,
                           const std::vector<std::filesystem::path>& inputs);

/// Writes the files that were asked for, all or none, then stdout. `json` is the document.
void write_swept(const sweep::Swept& swept, const SweepOptions& options,
                 const std::string& output_file, bool json_wanted, const std::string& json);

}  // namespace torquewright::cli
