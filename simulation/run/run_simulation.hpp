// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "actuator/motor/actuator.hpp"
#include "simulation/excitation.hpp"
#include "simulation/joint/joint_model.hpp"
#include "simulation/plant.hpp"
#include "simulation/run/imposed_motion.hpp"
#include "simulation/run/simulated_run.hpp"
#include "simulation/stepper/stepper.hpp"

namespace torquewright::simulation {

/// Simulates one run of actuators on a plant, from one sample of its excitation to a later one.
/// Sizes must agree. Keeps references to its arguments.
class RunSimulation {
 public:
  RunSimulation(Plant& plant, const std::vector<const actuator::Actuator*>& actuators,
                const Excitation& excitation, const std::vector<JointStart>& start,
                std::size_t first, const SimulationOptions& options);
  RunSimulation(const RunSimulation&) = delete;  // its stepper refers to its models
  RunSimulation& operator=(const RunSimulation&) = delete;

  /// Runs up to the sample `last`; may be called once. Ends early where the motion diverges.
  SimulatedRun run(std::size_t last);

 private:
  void begin(const std::vector<JointStart>& start);
  void interval(std::size_t knot);
  void step(std::size_t knot, double from, double width, double step_s);
  void step_imposed(std::size_t knot, double from, double width, double step_s,
                    const std::vector<DriveNow>& drive);
  void advance_states(std::size_t knot, double share, double step_s);
  void set_temperatures(std::size_t knot, double share);
  void heat(const std::vector<DriveNow>& drive, double step_s);
  void record(std::size_t knot);
  void record_motion();
  void record_joint(std::size_t joint, const PlantMotion& motion, const DriveNow& drive);
  double held_Nm(const std::vector<DriveNow>& drive, const Eigen::VectorXd& imposed);
  double energy_J();
  double longest_step_s() const;

  Plant& plant_;
  const Excitation& excitation_;
  std::size_t first_;
  bool traces_motion_only_;
  std::vector<JointModel> models_;
  Stepper stepper_;
  PlantState state_;
  std::optional<ImposedMotion> imposed_;
  SimulatedRun run_;
};

}  // namespace torquewright::simulation
