// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/flip/plan.hpp"
#include "hopper/replay/replay.hpp"

namespace torquewright::test {

constexpr double kDegree_rad = 0.017453292519943295;

const hopper::Robot& hopper_robot_of_plans();  ///< specs/robot/hopper.json
/// Its flip by the default options, planned once.
const hopper::PlanResult& planned_flip();

/// By the command's default options, in either engine.
hopper::ReplayResult replayed(const hopper::Robot& robot, const hopper::PlanResult& plan,
                              const hopper::EngineKind& engine);

/// The check of a copy of the plan's motion, as `hopper check` makes it of its file: torques and
/// contact forces are found anew, the plan's own are not in it.
hopper::HopperReport checked(const hopper::Robot& robot, const hopper::PlanResult& plan);

/// Of the centre of mass in the flight over its take-off, by the motion's samples.
double rise_m(const hopper::Robot& robot, const hopper::PlanResult& plan);

/// Of the robot's contact point, from the motion's first sample to its last.
Eigen::Vector3d moved_m(const hopper::Robot& robot, const hopper::PlanResult& plan,
                        std::size_t contact);

/// Difference between greatest and least CAM of a flight's instants, about +y.
double momentum_drift_Nm_s(const hopper::Robot& robot, const hopper::PlannedPhase& flight);

}  // namespace torquewright::test
