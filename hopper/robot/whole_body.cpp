// SPDX-License-Identifier: Apache-2.0
#include "hopper/robot/whole_body.hpp"

#include <algorithm>

#include "actuator/check/drive_check.hpp"
#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/mass_matrix.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::VectorIn;
using dynamics::VectorOut;
using Eigen::Index;

dynamics::Tree without_rotors(const Robot& robot) {
  dynamics::Tree tree = robot.tree;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    if (!drivetrain.rotors_in_tree || rotors_stay_in_tree(drivetrain)) continue;
    for (const std::size_t body : drivetrain.joints) tree.bodies[body].joint.reflected_inertia = 0;
  }
  return tree;
}

double rotor_kg_m2(const Robot& robot, const Drivetrain& drivetrain, std::size_t actuator) {
  if (rotors_stay_in_tree(drivetrain)) return 0.0;
  if (drivetrain.rotors_in_tree) {
    const double ratio =
        drivetrain.mechanism->constant_jacobian().value_or(SmallMatrix::Identity(1, 1))(0, 0);
    return robot.tree.bodies[drivetrain.joints.front()].joint.reflected_inertia / (ratio * ratio);
  }
  return turned_at_output_kg_m2(drivetrain, actuator);
}

double in_front_of_gears_kg_m2(const Robot& robot, const Drivetrain& drivetrain,
                               std::size_t index) {
  const actuator::Actuator& actuator = drivetrain.actuators[index];
  // A crank turns behind the gears.
  const double all_kg_m2 = rotors_stay_in_tree(drivetrain) ? actuator::armature_kg_m2(actuator)
                           : drivetrain.rotors_in_tree     ? rotor_kg_m2(robot, drivetrain, index)
                                                       : rotor_at_output_kg_m2(drivetrain, index);
  return std::max(0.0, all_kg_m2 - actuator.transmission.inertia_kg_m2);
}

}  // namespace

bool rotors_stay_in_tree(const Drivetrain& drivetrain) {
  return drivetrain.rotors_in_tree &&
         (drivetrain.joints.size() > 1 || !drivetrain.mechanism->constant_jacobian());
}

WholeBody::WholeBody(const Robot& robot)
    : robot_(&robot),
      state_(without_rotors(robot)),
      position_(dynamics::zero_position(robot.tree)) {
  for (std::size_t i = 0; i < robot.drivetrains.size(); ++i) {
    const Drivetrain& drivetrain = robot.drivetrains[i];
    first_drive_.push_back(rotors_kg_m2_.size());
    for (std::size_t j = 0; j < drivetrain.actuators.size(); ++j) {
      rotors_kg_m2_.push_back(rotor_kg_m2(robot, drivetrain, j));
      before_gears_kg_m2_.push_back(in_front_of_gears_kg_m2(robot, drivetrain, j));
    }
  }
  transfers_.resize(robot.drivetrains.size());
}

bool WholeBody::set(const VectorIn& position, const VectorIn& velocity) {
  state_.set(position, velocity);
  const Index joints = static_cast<Index>(state_.tree().bodies.size()) - 1;
  for (std::size_t i = 0; i < robot_->drivetrains.size(); ++i) {
    const Drivetrain& drivetrain = robot_->drivetrains[i];
    const auto count = static_cast<Index>(drivetrain.joints.size());
    SmallVector joint_rad(count);
    SmallVector joint_rad_s(count);
    for (Index j = 0; j < count; ++j) {
      const auto body = static_cast<Index>(drivetrain.joints[static_cast<std::size_t>(j)]);
      joint_rad[j] = position[position.size() - joints + body - 1];
      joint_rad_s[j] = velocity[velocity.size() - joints + body - 1];
    }
    const auto transfer = drivetrain.mechanism->transfer(joint_rad, joint_rad_s);
    if (!transfer) {
      unreached_ = i;
      return false;
    }
    transfers_[i] = *transfer;
  }
  return true;
}

SmallVector WholeBody::joints_of(const Drivetrain& drivetrain, const VectorIn& values) const {
  SmallVector part(static_cast<Index>(drivetrain.joints.size()));
  for (Index j = 0; j < part.size(); ++j) {
    part[j] = values[state_.joint_row(drivetrain.joints[static_cast<std::size_t>(j)])];
  }
  return part;
}

SmallVector WholeBody::accelerations(std::size_t drivetrain, const VectorIn& acceleration) const {
  const Drivetrain& joints = robot_->drivetrains[drivetrain];
  const Transfer& transfer = transfers_[drivetrain];
  const SmallVector speeds = joints_of(joints, state_.velocity());
  return transfer.jacobian * joints_of(joints, acceleration) + transfer.jacobian_rate_1_s * speeds;
}

void WholeBody::mass_matrix(dynamics::MatrixOut out) {
  dynamics::mass_matrix(state_, out);
  add_rotor_inertia(out);
}

void WholeBody::add_rotor_inertia(dynamics::MatrixOut out) const {
  for (std::size_t i = 0; i < robot_->drivetrains.size(); ++i) {
    const Drivetrain& drivetrain = robot_->drivetrains[i];
    const SmallMatrix& J = transfers_[i].jacobian;
    SmallMatrix weighted = J;
    for (Index j = 0; j < J.rows(); ++j) {
      weighted.row(j) *= rotors_kg_m2_[first_drive_[i] + static_cast<std::size_t>(j)];
    }
    const SmallMatrix reflected = J.transpose() * weighted;
    for (Index row = 0; row < J.cols(); ++row) {
      for (Index column = 0; column < J.cols(); ++column) {
        const auto at = [&](Index k) {
          return state_.joint_row(drivetrain.joints[static_cast<std::size_t>(k)]);
        };
        out(at(row), at(column)) += reflected(row, column);
      }
    }
  }
}

void WholeBody::inverse_dynamics(const VectorIn& acceleration, VectorOut force) {
  dynamics::inverse_dynamics(state_, acceleration, force);
  add_rotors(acceleration, force);
}

void WholeBody::add_rotors(const VectorIn& acceleration, VectorOut force) const {
  for (std::size_t i = 0; i < robot_->drivetrains.size(); ++i) {
    SmallVector torque_Nm = accelerations(i, acceleration);
    for (Index j = 0; j < torque_Nm.size(); ++j) {
      torque_Nm[j] *= rotors_kg_m2_[first_drive_[i] + static_cast<std::size_t>(j)];
    }
    const SmallVector at_joints_Nm = joint_torque_Nm(transfers_[i], torque_Nm);
    for (Index j = 0; j < at_joints_Nm.size(); ++j) {
      force[state_.joint_row(robot_->drivetrains[i].joints[static_cast<std::size_t>(j)])] +=
          at_joints_Nm[j];
    }
  }
}

void WholeBody::drives(const VectorIn& acceleration, const VectorIn& load_force,
                       std::vector<DriveInstant>& out) const {
  out.resize(drive_count());
  for (std::size_t i = 0; i < robot_->drivetrains.size(); ++i) {
    const Drivetrain& drivetrain = robot_->drivetrains[i];
    const SmallVector speeds = transfers_[i].jacobian * joints_of(drivetrain, state_.velocity());
    const SmallVector rates = accelerations(i, acceleration);
    const SmallVector loads = actuator_torque_Nm(transfers_[i], joints_of(drivetrain, load_force));
    for (Index j = 0; j < speeds.size(); ++j) {
      const std::size_t drive = first_drive_[i] + static_cast<std::size_t>(j);
      out[drive] = {transfers_[i].actuator_position_rad[j], speeds[j], rates[j], loads[j],
                    loads[j] + rotors_kg_m2_[drive] * rates[j]};
    }
  }
}

void WholeBody::at_actuators(const VectorIn& force, VectorOut torque_Nm) const {
  for (std::size_t i = 0; i < robot_->drivetrains.size(); ++i) {
    const SmallVector part =
        actuator_torque_Nm(transfers_[i], joints_of(robot_->drivetrains[i], force));
    for (Index j = 0; j < part.size(); ++j) {
      torque_Nm[static_cast<Index>(first_drive_[i]) + j] = part[j];
    }
  }
}

void WholeBody::speed_changes(const VectorIn& change, VectorOut at_actuators) const {
  for (std::size_t i = 0; i < robot_->drivetrains.size(); ++i) {
    const SmallVector part = transfers_[i].jacobian * joints_of(robot_->drivetrains[i], change);
    for (Index j = 0; j < part.size(); ++j) {
      at_actuators[static_cast<Index>(first_drive_[i]) + j] = part[j];
    }
  }
}

void WholeBody::joint_forces(const VectorIn& at_actuators_Nm, VectorOut force) const {
  force.setZero();
  for (std::size_t i = 0; i < robot_->drivetrains.size(); ++i) {
    const Drivetrain& drivetrain = robot_->drivetrains[i];
    const auto count = static_cast<Index>(drivetrain.joints.size());
    const SmallVector at_joints_Nm = joint_torque_Nm(
        transfers_[i], at_actuators_Nm.segment(static_cast<Index>(first_drive_[i]), count));
    for (Index j = 0; j < count; ++j) {
      force[state_.joint_row(drivetrain.joints[static_cast<std::size_t>(j)])] += at_joints_Nm[j];
    }
  }
}

}  // namespace torquewright::hopper
