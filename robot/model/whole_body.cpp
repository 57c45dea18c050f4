// SPDX-License-Identifier: Apache-2.0
#include "robot/model/whole_body.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "actuator/region/torque_at.hpp"
#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/jet.hpp"
#include "dynamics/mass_matrix.hpp"
#include "dynamics/passive_forces.hpp"
#include "robot/mechanisms/loop.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::VectorIn;
using dynamics::VectorInOf;
using dynamics::VectorOut;
using dynamics::VectorOutOf;
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
  if (drivetrain.rotors_in_tree) return rotor_in_tree_kg_m2(robot, drivetrain);
  return turned_at_output_kg_m2(drivetrain, actuator);
}

double in_front_of_gears_kg_m2(const Robot& robot, const Drivetrain& drivetrain,
                               std::size_t index) {
  const actuator::Actuator& actuator = drivetrain.actuators[index];
  // A crank turns behind the gears.
  const double all_kg_m2 = rotors_stay_in_tree(drivetrain)
                               ? actuator::reflected_inertia_kg_m2(actuator)
                           : drivetrain.rotors_in_tree ? rotor_kg_m2(robot, drivetrain, index)
                                                       : rotor_at_output_kg_m2(drivetrain, index);
  return std::max(0.0, all_kg_m2 - actuator.transmission.inertia_kg_m2);
}

std::vector<HeldLoop> loops_of(const Robot& robot) {
  std::vector<HeldLoop> loops;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    const auto* loop = dynamic_cast<const Loop*>(drivetrain.mechanism.get());
    if (loop != nullptr) loops.push_back({&loop->links(), drivetrain.joints});
  }
  for (const Follower& follower : robot.followers) {
    loops.push_back({follower.links.get(), follower.joints});
  }
  return loops;
}

}  // namespace

bool rotors_stay_in_tree(const Drivetrain& drivetrain) {
  return drivetrain.rotors_in_tree &&
         (drivetrain.joints.size() > 1 || !drivetrain.mechanism->constant_jacobian());
}

double rotor_in_tree_kg_m2(const Robot& robot, const Drivetrain& drivetrain) {
  const double ratio =
      drivetrain.mechanism->constant_jacobian().value_or(SmallMatrix::Identity(1, 1))(0, 0);
  return robot.tree.bodies[drivetrain.joints.front()].joint.reflected_inertia / (ratio * ratio);
}

template <typename T>
WholeBodyOf<T>::WholeBodyOf(const Robot& robot)
    : robot_(&robot),
      state_(without_rotors(robot)),
      linked_(state_.tree(), loops_of(robot)),
      followed_(linked_.loops().size()) {
  for (std::size_t i = 0; i < robot.drivetrains.size(); ++i) {
    const Drivetrain& drivetrain = robot.drivetrains[i];
    first_drive_.push_back(rotors_kg_m2_.size());
    const auto* loop = dynamic_cast<const Loop*>(drivetrain.mechanism.get());
    for (const HeldLoop& held : linked_.loops()) {
      if (loop != nullptr && held.links == &loop->links()) linked_drivetrains_.push_back(i);
    }
    for (std::size_t j = 0; j < drivetrain.actuators.size(); ++j) {
      rotors_kg_m2_.push_back(rotor_kg_m2(robot, drivetrain, j));
      before_gears_kg_m2_.push_back(in_front_of_gears_kg_m2(robot, drivetrain, j));
    }
  }
  transfers_.resize(robot.drivetrains.size());
}

template <typename T>
bool WholeBodyOf<T>::set(const VectorInOf<T>& position, const VectorInOf<T>& velocity) {
  state_.set(position, velocity);
  for (std::size_t i = 0; i < robot_->drivetrains.size(); ++i) {
    if (set_drivetrain(i)) continue;
    const Drivetrain& drivetrain = robot_->drivetrains[i];
    unreached_ = {fmt::format("the {} mechanism of {}", drivetrain.mechanism->type(),
                              drivetrain.actuator_names.front()),
                  drivetrain.joints};
    return false;
  }
  for (std::size_t i = linked_drivetrains_.size(); i < linked_.loops().size(); ++i) {
    if (set_follower(i)) continue;
    const HeldLoop& held = linked_.loops()[i];
    unreached_ = {fmt::format("the follower \"{}\"",
                              held.links->geometry().tree.bodies[held.joints.size() + 1].name),
                  held.joints};
    return false;
  }
  if (!linked_.is_empty()) linked_.set(position, velocity, followed_);
  return true;
}

template <typename T>
bool WholeBodyOf<T>::set_drivetrain(std::size_t index) {
  const auto linked = std::find(linked_drivetrains_.begin(), linked_drivetrains_.end(), index);
  if (linked != linked_drivetrains_.end()) {
    return set_loop(index, static_cast<std::size_t>(linked - linked_drivetrains_.begin()));
  }
  const Drivetrain& drivetrain = robot_->drivetrains[index];
  const auto transfer = transfer_of<T>(*drivetrain.mechanism, positions_of(drivetrain),
                                       joints_of(drivetrain, state_.velocity()));
  if (!transfer) return false;
  transfers_[index] = *transfer;
  return true;
}

/// Its links move on the way to its actuators: they are followed once.
template <typename T>
bool WholeBodyOf<T>::set_loop(std::size_t drivetrain, std::size_t loop) {
  if (!set_follower(loop)) return false;
  const auto& mechanism = dynamic_cast<const Loop&>(*robot_->drivetrains[drivetrain].mechanism);
  const auto transfer = mechanism.transfer_of_followed<T>(followed_[loop]);
  if (!transfer) return false;
  transfers_[drivetrain] = *transfer;
  return true;
}

template <typename T>
bool WholeBodyOf<T>::set_follower(std::size_t loop) {
  const HeldLoop& held = linked_.loops()[loop];
  const auto count = static_cast<Index>(held.joints.size());
  dynamics::VectorX<T> joint_rad(count), joint_rad_s(count);
  for (Index j = 0; j < count; ++j) {
    const std::size_t body = held.joints[static_cast<std::size_t>(j)];
    joint_rad[j] = state_.joint_position(body);
    joint_rad_s[j] = state_.joint_velocity(body);
  }
  auto followed = held.links->template follow<T>(joint_rad, joint_rad_s);
  if (!followed) return false;
  followed_[loop] = std::move(*followed);
  return true;
}

template <typename T>
SmallVectorOf<T> WholeBodyOf<T>::joints_of(const Drivetrain& drivetrain,
                                           const VectorInOf<T>& values) const {
  SmallVectorOf<T> part(static_cast<Index>(drivetrain.joints.size()));
  for (Index j = 0; j < part.size(); ++j) {
    part[j] = values[state_.joint_row(drivetrain.joints[static_cast<std::size_t>(j)])];
  }
  return part;
}

template <typename T>
SmallVectorOf<T> WholeBodyOf<T>::positions_of(const Drivetrain& drivetrain) const {
  SmallVectorOf<T> part(static_cast<Index>(drivetrain.joints.size()));
  for (Index j = 0; j < part.size(); ++j) {
    part[j] = state_.joint_position(drivetrain.joints[static_cast<std::size_t>(j)]);
  }
  return part;
}

template <typename T>
SmallVectorOf<T> WholeBodyOf<T>::accelerations(std::size_t drivetrain,
                                               const VectorInOf<T>& acceleration) const {
  const Drivetrain& joints = robot_->drivetrains[drivetrain];
  const TransferOf<T>& transfer = transfers_[drivetrain];
  const SmallVectorOf<T> speeds = joints_of(joints, state_.velocity());
  return transfer.jacobian * joints_of(joints, acceleration) + transfer.jacobian_rate_1_s * speeds;
}

template <typename T>
void WholeBodyOf<T>::mass_matrix(dynamics::MatrixOutOf<T> out) {
  if (linked_.is_empty()) {
    dynamics::mass_matrix(state_, out);
  } else {
    linked_.mass_matrix(out);
  }
  add_rotor_inertia(out);
}

template <typename T>
void WholeBodyOf<T>::add_rotor_inertia(dynamics::MatrixOutOf<T> out) const {
  for (std::size_t i = 0; i < robot_->drivetrains.size(); ++i) {
    const Drivetrain& drivetrain = robot_->drivetrains[i];
    const SmallMatrixOf<T>& J = transfers_[i].jacobian;
    SmallMatrixOf<T> weighted = J;
    for (Index j = 0; j < J.rows(); ++j) {
      weighted.row(j) *= rotors_kg_m2_[first_drive_[i] + static_cast<std::size_t>(j)];
    }
    const SmallMatrixOf<T> reflected = J.transpose() * weighted;
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

template <typename T>
void WholeBodyOf<T>::inverse_dynamics(const VectorInOf<T>& acceleration, VectorOutOf<T> force) {
  body_forces(acceleration, force);
  add_rotors(acceleration, force);
  add_dampers_and_springs(force);
}

/// The tree's own state has the bodies' accelerations afterwards, whether or not there are links.
template <typename T>
void WholeBodyOf<T>::body_forces(const VectorInOf<T>& acceleration, VectorOutOf<T> force) {
  dynamics::inverse_dynamics(state_, acceleration, force);
  if (!linked_.is_empty()) linked_.inverse_dynamics(acceleration, force);
}

template <typename T>
void WholeBodyOf<T>::add_dampers_and_springs(VectorOutOf<T> force) const {
  if (linked_.is_empty()) {
    dynamics::add_dampers_and_springs(state_, force);
  } else {
    linked_.add_dampers_and_springs(force);
  }
}

template <typename T>
void WholeBodyOf<T>::add_dry_friction(const VectorIn& acceleration,
                                      VectorOut force) const requires std::same_as<T, double> {
  if (linked_.is_empty()) {
    dynamics::add_dry_friction(state_, acceleration, force);
  } else {
    linked_.add_dry_friction(acceleration, force);
  }
}

template <typename T>
void WholeBodyOf<T>::held_by_friction(const VectorIn& acceleration, const VectorIn& needed,
                                      VectorOut held) const requires std::same_as<T, double> {
  if (linked_.is_empty()) {
    dynamics::held_by_friction(state_, acceleration, needed, held);
  } else {
    linked_.held_by_friction(acceleration, needed, held);
  }
}

template <typename T>
std::span<const dynamics::Body> WholeBodyOf<T>::links() const {
  if (linked_.is_empty()) return {};
  return std::span(linked_.state().tree().bodies).subspan(state_.tree().bodies.size());
}

template <typename T>
dynamics::VectorX<T> WholeBodyOf<T>::link_motion(std::size_t link) const {
  return linked_.motions().row(state_.velocity().size() + static_cast<Index>(link)).transpose();
}

template <typename T>
void WholeBodyOf<T>::add_link_inertia(
    dynamics::MatrixOutOf<T> out) requires std::same_as<T, double> {
  if (linked_.is_empty()) return;
  Eigen::MatrixXd with(out.rows(), out.cols()), without(out.rows(), out.cols());
  linked_.mass_matrix(with);
  dynamics::mass_matrix(state_, without);
  out += with - without;
}

template <typename T>
void WholeBodyOf<T>::add_link_forces(VectorOutOf<T> force) requires std::same_as<T, double> {
  if (linked_.is_empty()) return;
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(force.size());
  Eigen::VectorXd with(force.size()), without(force.size());
  linked_.inverse_dynamics(rest, with);
  linked_.add_dampers_and_springs(with);
  dynamics::inverse_dynamics(state_, rest, without);
  dynamics::add_dampers_and_springs(state_, without);
  force += with - without;
}

template <typename T>
dynamics::Centroid WholeBodyOf<T>::centroid() requires std::same_as<T, double> {
  return dynamics::centroid(linked_.is_empty() ? state_ : linked_.state());
}

template <typename T>
void WholeBodyOf<T>::add_rotors(const VectorInOf<T>& acceleration, VectorOutOf<T> force) const {
  for (std::size_t i = 0; i < robot_->drivetrains.size(); ++i) {
    SmallVectorOf<T> torque_Nm = accelerations(i, acceleration);
    for (Index j = 0; j < torque_Nm.size(); ++j) {
      torque_Nm[j] *= rotors_kg_m2_[first_drive_[i] + static_cast<std::size_t>(j)];
    }
    add_at_joints(robot_->drivetrains[i], joint_torque_Nm(transfers_[i], torque_Nm), force);
  }
}

template <typename T>
void WholeBodyOf<T>::add_drive_torques(const VectorInOf<T>& drive_Nm, VectorOutOf<T> force) const {
  for (std::size_t i = 0; i < robot_->drivetrains.size(); ++i) {
    const auto count = static_cast<Index>(robot_->drivetrains[i].actuators.size());
    const SmallVectorOf<T> torque_Nm = drive_Nm.segment(static_cast<Index>(first_drive_[i]), count);
    add_at_joints(robot_->drivetrains[i], joint_torque_Nm(transfers_[i], torque_Nm), force);
  }
}

template <typename T>
void WholeBodyOf<T>::add_at_joints(const Drivetrain& drivetrain, const SmallVectorOf<T>& torque_Nm,
                                   VectorOutOf<T>& force) const {
  for (Index j = 0; j < torque_Nm.size(); ++j) {
    force[state_.joint_row(drivetrain.joints[static_cast<std::size_t>(j)])] += torque_Nm[j];
  }
}

template <typename T>
std::vector<Eigen::Vector3d> WholeBodyOf<T>::turning(
    const VectorIn& acceleration, bool has_products) const requires std::same_as<T, double> {
  const std::vector<dynamics::Body>& bodies = state_.tree().bodies;
  std::vector<Eigen::Vector3d> turning(bodies.size(), Eigen::Vector3d::Zero());
  if (state_.tree().base == dynamics::BaseKind::kPlanar) {
    turning[0].y() = acceleration[2];
  } else if (state_.tree().base == dynamics::BaseKind::kSpatial) {
    turning[0] = state_.motion(0).R_WB * acceleration.segment<3>(3);
  }
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    turning[i] = turning[bodies[i].parent];
    if (bodies[i].joint.kind != dynamics::JointKind::kRevolute) continue;
    const Eigen::Vector3d& axis = state_.motion(i).axis;
    turning[i] += acceleration[state_.joint_row(i)] * axis;
    if (!has_products) continue;
    const Eigen::Vector3d& carrier_rad_s = state_.motion(bodies[i].parent).angular_velocity_rad_s;
    turning[i] += state_.joint_velocity(i) * carrier_rad_s.cross(axis);
  }
  return turning;
}

template <typename T>
Eigen::VectorXd WholeBodyOf<T>::carried(
    const std::vector<Eigen::Vector3d>& turning) const requires std::same_as<T, double> {
  const std::vector<dynamics::Body>& bodies = state_.tree().bodies;
  Eigen::VectorXd carried = Eigen::VectorXd::Zero(state_.tree().velocity_size());
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const std::size_t carrier = bodies[i].parent;
    carried[state_.joint_row(i)] =
        (state_.motion(carrier).R_WB * bodies[i].joint.rotor_spin_kg_m2).dot(turning[carrier]);
  }
  return carried;
}

template <typename T>
void WholeBodyOf<T>::carried_momenta(
    const VectorIn& velocity, VectorOut at_actuators) const requires std::same_as<T, double> {
  this->at_actuators(carried(turning(velocity, false)), at_actuators);
}

template <typename T>
void WholeBodyOf<T>::drives(const VectorIn& acceleration, const VectorIn& load_force,
                            std::vector<DriveInstant>& out) const requires std::same_as<T, double> {
  out.resize(drive_count());
  Eigen::VectorXd carried_Nm(static_cast<Index>(drive_count()));
  at_actuators(carried(turning(acceleration, true)), carried_Nm);
  for (std::size_t i = 0; i < robot_->drivetrains.size(); ++i) {
    const Drivetrain& drivetrain = robot_->drivetrains[i];
    const SmallVector speeds = transfers_[i].jacobian * joints_of(drivetrain, state_.velocity());
    const SmallVector rates = accelerations(i, acceleration);
    const SmallVector loads = actuator_torque_Nm(transfers_[i], joints_of(drivetrain, load_force));
    for (Index j = 0; j < speeds.size(); ++j) {
      const std::size_t drive = first_drive_[i] + static_cast<std::size_t>(j);
      out[drive] = {transfers_[i].actuator_position_rad[j],
                    speeds[j],
                    rates[j],
                    loads[j],
                    loads[j] + rotors_kg_m2_[drive] * rates[j],
                    carried_Nm[static_cast<Index>(drive)]};
    }
  }
}

template <typename T>
void WholeBodyOf<T>::at_actuators(const VectorIn& force,
                                  VectorOut torque_Nm) const requires std::same_as<T, double> {
  for (std::size_t i = 0; i < robot_->drivetrains.size(); ++i) {
    const SmallVector part =
        actuator_torque_Nm(transfers_[i], joints_of(robot_->drivetrains[i], force));
    for (Index j = 0; j < part.size(); ++j) {
      torque_Nm[static_cast<Index>(first_drive_[i]) + j] = part[j];
    }
  }
}

template <typename T>
void WholeBodyOf<T>::speed_changes(const VectorIn& change,
                                   VectorOut at_actuators) const requires std::same_as<T, double> {
  for (std::size_t i = 0; i < robot_->drivetrains.size(); ++i) {
    const SmallVector part = transfers_[i].jacobian * joints_of(robot_->drivetrains[i], change);
    for (Index j = 0; j < part.size(); ++j) {
      at_actuators[static_cast<Index>(first_drive_[i]) + j] = part[j];
    }
  }
}

template <typename T>
void WholeBodyOf<T>::drive_positions(
    VectorOut at_actuators) const requires std::same_as<T, double> {
  for (std::size_t i = 0; i < robot_->drivetrains.size(); ++i) {
    const SmallVector& position_rad = transfers_[i].actuator_position_rad;
    for (Index j = 0; j < position_rad.size(); ++j) {
      at_actuators[static_cast<Index>(first_drive_[i]) + j] = position_rad[j];
    }
  }
}

template class WholeBodyOf<double>;
// Member by member: those in double alone are left out.
template WholeBodyOf<dynamics::Jet>::WholeBodyOf(const Robot&);
template bool WholeBodyOf<dynamics::Jet>::set(const VectorInOf<dynamics::Jet>&,
                                              const VectorInOf<dynamics::Jet>&);
template void WholeBodyOf<dynamics::Jet>::mass_matrix(dynamics::MatrixOutOf<dynamics::Jet>);
template void WholeBodyOf<dynamics::Jet>::body_forces(const VectorInOf<dynamics::Jet>&,
                                                      VectorOutOf<dynamics::Jet>);
template void WholeBodyOf<dynamics::Jet>::add_dampers_and_springs(VectorOutOf<dynamics::Jet>) const;
template void WholeBodyOf<dynamics::Jet>::inverse_dynamics(const VectorInOf<dynamics::Jet>&,
                                                           VectorOutOf<dynamics::Jet>);
template void WholeBodyOf<dynamics::Jet>::add_rotors(const VectorInOf<dynamics::Jet>&,
                                                     VectorOutOf<dynamics::Jet>) const;
template void WholeBodyOf<dynamics::Jet>::add_drive_torques(const VectorInOf<dynamics::Jet>&,
                                                            VectorOutOf<dynamics::Jet>) const;
template WholeBodyOf<dynamics::Jet2>::WholeBodyOf(const Robot&);
template bool WholeBodyOf<dynamics::Jet2>::set(const VectorInOf<dynamics::Jet2>&,
                                               const VectorInOf<dynamics::Jet2>&);
template void WholeBodyOf<dynamics::Jet2>::mass_matrix(dynamics::MatrixOutOf<dynamics::Jet2>);
template void WholeBodyOf<dynamics::Jet2>::body_forces(const VectorInOf<dynamics::Jet2>&,
                                                       VectorOutOf<dynamics::Jet2>);
template void WholeBodyOf<dynamics::Jet2>::add_dampers_and_springs(
    VectorOutOf<dynamics::Jet2>) const;
template void WholeBodyOf<dynamics::Jet2>::inverse_dynamics(const VectorInOf<dynamics::Jet2>&,
                                                            VectorOutOf<dynamics::Jet2>);
template void WholeBodyOf<dynamics::Jet2>::add_rotors(const VectorInOf<dynamics::Jet2>&,
                                                      VectorOutOf<dynamics::Jet2>) const;
template void WholeBodyOf<dynamics::Jet2>::add_drive_torques(const VectorInOf<dynamics::Jet2>&,
                                                             VectorOutOf<dynamics::Jet2>) const;

}  // namespace torquewright::hopper
