// SPDX-License-Identifier: Apache-2.0
#include "identification/signals/load_model.hpp"

#include <cmath>

#include "dynamics/gravity.hpp"
#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/serial_arm.hpp"
#include "identification/simulated/rig_plant.hpp"

namespace torquewright::identification {
namespace {

std::vector<double> arm_load_Nm(const Load& load, std::size_t joint, const Signals& signals) {
  dynamics::SerialArm arm(serial_links_of(load), dynamics::kGravity_m_s2);
  const Eigen::Index joints = arm.joint_count();
  Eigen::VectorXd q(joints), v(joints), a(joints), torque(joints);
  std::vector<double> load_Nm(signals.size());
  for (std::size_t i = 0; i < signals.size(); ++i) {
    for (Eigen::Index j = 0; j < joints; ++j) {
      const JointMotion& motion = signals.arm[static_cast<std::size_t>(j)];
      q[j] = motion.position_rad[i];
      v[j] = motion.velocity_rad_s[i];
      a[j] = motion.acceleration_rad_s2[i];
    }
    arm.inverse_dynamics(q, v, a, torque);
    load_Nm[i] = torque[static_cast<Eigen::Index>(joint)];
  }
  return load_Nm;
}

std::vector<double> robot_load_Nm(const Load& load, std::size_t joint, const Signals& signals) {
  dynamics::TreeState state(robot_tree_of(load));
  const RobotLoad& robot = *load.robot;
  Eigen::VectorXd q = held_positions_of(load);
  Eigen::VectorXd v = Eigen::VectorXd::Zero(q.size()), a = v, torque = v;
  std::vector<double> load_Nm(signals.size());
  for (std::size_t i = 0; i < signals.size(); ++i) {
    for (std::size_t j = 0; j < robot.bodies.size(); ++j) {
      const Eigen::Index row = state.joint_row(robot.bodies[j]);
      q[row] = signals.arm[j].position_rad[i];
      v[row] = signals.arm[j].velocity_rad_s[i];
      a[row] = signals.arm[j].acceleration_rad_s2[i];
    }
    state.set(q, v);
    dynamics::inverse_dynamics(state, a, torque);
    load_Nm[i] = torque[state.joint_row(robot.bodies[joint])];
  }
  return load_Nm;
}

}  // namespace

double load_mass_column(const Load& load, const actuator::Instant& at) {
  if (load.type == LoadType::kLinearAxis) return at.acceleration_rad_s2;
  return load.length_m * load.length_m * at.acceleration_rad_s2 +
         dynamics::kGravity_m_s2 * load.length_m * std::sin(at.output_angle_rad);
}

std::vector<double> model_load_Nm(const Rig& rig, std::size_t joint, const Signals& signals) {
  const Load& load = load_of(rig, signals.run_name);
  if (load.type == LoadType::kSerialArm) return arm_load_Nm(load, joint, signals);
  if (load.type == LoadType::kRobot) return robot_load_Nm(load, joint, signals);
  std::vector<double> load_Nm(signals.size(), 0.0);
  for (std::size_t i = 0; i < signals.size(); ++i) {
    const actuator::Instant& at = signals.at[i];
    switch (load.type) {
      case LoadType::kFree:
        load_Nm[i] = load.inertia_kg_m2 * at.acceleration_rad_s2;
        break;
      case LoadType::kLinearAxis:
        load_Nm[i] = load.mass_kg * load_mass_column(load, at);
        break;
      case LoadType::kPendulum:
        load_Nm[i] =
            load.inertia_kg_m2 * at.acceleration_rad_s2 + load.mass_kg * load_mass_column(load, at);
        break;
      case LoadType::kDynamometer:
      case LoadType::kSerialArm:
      case LoadType::kRobot:
        break;
    }
  }
  return load_Nm;
}

}  // namespace torquewright::identification
