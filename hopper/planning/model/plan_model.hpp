// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "hopper/planning/model/laws.hpp"
#include "hopper/planning/tasks/plan_options.hpp"
#include "optimization/nonlinear/program.hpp"

namespace torquewright::hopper {

/// The model that is planned with: the robot in its plane, its drives, and what feeds them.
struct PlanModel {
  SagittalRobot plane;
  std::shared_ptr<const std::vector<DriveRegion>> regions;
  std::shared_ptr<const std::vector<PlanSupply>> supplies;
  /// Ranges of the joints that move, margins taken off.
  std::vector<optimization::Bounds> joint_rad;
  std::vector<optimization::Bounds> flight_rad;  ///< The same in flight.
  std::vector<double> joint_rad_s;               ///< Greatest speeds of the joints.
  std::vector<double> joint_Nm;  ///< Greatest torques of the joints; may be infinite.
  std::vector<double> gear_Nm;  ///< Greatest gear torques by drive, at its output; may be infinite.
  std::vector<double> rotors_kg_m2;  ///< Inertia of rotors by drive, before its gears.
  double weight_N = 0.0;
  double size_m = 0.0;         ///< Radius of gyration about the pitch axis, joints at 0.
  double foot_length_m = 0.0;  ///< Length from the rearmost to the foremost point of the sole.
};

PlanModel plan_model(const Robot& robot, const PlanOptions& options);

/// How many voltages are unknown at an instant: one a supply that has a resistance.
Eigen::Index bus_count(const PlanModel& model);

}  // namespace torquewright::hopper
