// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "identification/rig/rig.hpp"
#include "simulation/run/simulate.hpp"

namespace torquewright::identification {

/// An excitation as a file states it: named runs.
struct ExcitationRun {
  std::string name;  ///< Name of the run; empty: the file has no runs.
  simulation::Excitation excitation;
  simulation::JointStart start;
};

/// Reads a CSV whose columns are quantities of the contract by their names: time_s; one of
/// motor_current_A, commanded_torque_Nm, winding_voltage_V, duty; on a dynamometer
/// output_velocity_rad_s besides (positions follow, from the first output_position_rad or 0); `run`
/// where there are several. Throws io::SpecError, also for a column that nothing of the rig takes,
/// and for what the actuator's drive cannot play: a duty beyond 1, a current (or the current of a
/// torque) beyond its peak.
std::vector<ExcitationRun> read_excitation(const std::filesystem::path& file, const Rig& rig,
                                           const actuator::Actuator& actuator);

/// Throws io::SpecError where the runs of that file would take more simulation steps than the
/// program is ready to compute.
void require_few_steps(const std::filesystem::path& file, const std::vector<ExcitationRun>& runs,
                       const simulation::SimulationOptions& options);

/// Returns a quantity along a simulated run of one joint; empty where a simulation does not have
/// it.
std::vector<double> simulated_quantity(Quantity quantity, const actuator::Actuator& truth,
                                       const simulation::Excitation& excitation,
                                       const simulation::JointTrace& trace);

struct SimulatedLogOptions {
  std::map<Quantity, double> noise;  ///< Standard deviation of white noise, in the quantity's unit.
  std::uint64_t seed = 1;
  simulation::SimulationOptions simulation;
};

/// Returns the text of a log, in the rig's columns, of an actuator taken as true. Throws
/// io::SpecError for a rig of several joints, a column that a simulation cannot fill, and a motion
/// that diverges.
std::string simulated_log(const Rig& rig, const actuator::Actuator& truth,
                          const std::vector<ExcitationRun>& runs,
                          const SimulatedLogOptions& options);

}  // namespace torquewright::identification
