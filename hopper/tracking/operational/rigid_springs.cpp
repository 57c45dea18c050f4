// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/operational/rigid_springs.hpp"

#include <Eigen/QR>

#include "robot/mechanisms/loop.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of a row's length, what is left of one that others make up: of two points of one foot.
constexpr double kSameRow = 1e-9;

std::vector<Index> rows_without_drive(const Robot& robot) {
  std::vector<bool> is_driven(robot.tree.bodies.size(), false);
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (const std::size_t joint : drivetrain.joints) is_driven[joint] = true;
  }
  std::vector<Index> rows;
  for (std::size_t body = 1; body < is_driven.size(); ++body) {
    if (is_driven[body]) continue;
    rows.push_back(robot.tree.base_velocity_size() + static_cast<Index>(body) - 1);
  }
  return rows;
}

VectorXd least_move(const MatrixXd& rows, const VectorXd& wanted) {
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> parts;
  parts.setThreshold(kSameRow);
  return parts.compute(rows).solve(wanted);
}

}  // namespace

RigidSprings::RigidSprings(const Robot& robot, const std::vector<RigidJoint>& joints)
    : robot_(&robot), undriven_(rows_without_drive(robot)) {
  const WholeBody whole(robot);
  for (const RigidJoint& joint : joints) {
    Spring spring;
    spring.joint = joint;
    if (joint.is_link) find(whole.links()[joint.of].joint.name, spring);
    springs_.push_back(spring);
  }
}

void RigidSprings::find(const std::string& name, Spring& spring) const {
  const auto look_in = [&](const ClosedLinks& links, const std::vector<std::size_t>& joints) {
    const auto& bodies = links.geometry().tree.bodies;
    for (std::size_t i = joints.size() + 1; i < bodies.size(); ++i) {
      if (bodies[i].joint.name != name) continue;
      spring.links = &links;
      spring.joints = joints;
      spring.place = static_cast<Index>(i) - 1;
    }
  };
  for (const Follower& follower : robot_->followers) look_in(*follower.links, follower.joints);
  for (const Drivetrain& drivetrain : robot_->drivetrains) {
    const auto* loop = dynamic_cast<const Loop*>(drivetrain.mechanism.get());
    if (loop != nullptr) look_in(loop->links(), drivetrain.joints);
  }
}

MatrixXd RigidSprings::rates(const WholeBody& body) const {
  MatrixXd rows = MatrixXd::Zero(size(), robot_->tree.velocity_size());
  for (Index i = 0; i < size(); ++i) {
    const RigidJoint& joint = springs_[static_cast<std::size_t>(i)].joint;
    if (joint.is_link) {
      rows.row(i) = body.link_motion(joint.of).transpose();
    } else {
      rows(i, robot_->tree.base_velocity_size() + static_cast<Index>(joint.of) - 1) = 1.0;
    }
  }
  return rows;
}

VectorXd RigidSprings::places(const WholeBody& body) const {
  VectorXd places(size());
  for (Index i = 0; i < size(); ++i) {
    const Spring& spring = springs_[static_cast<std::size_t>(i)];
    if (spring.links == nullptr) {
      places[i] = body.state().joint_position(spring.joint.of);
      continue;
    }
    VectorXd joints(static_cast<Index>(spring.joints.size()));
    for (Index j = 0; j < joints.size(); ++j) {
      joints[j] = body.state().joint_position(spring.joints[static_cast<std::size_t>(j)]);
    }
    const VectorXd still = VectorXd::Zero(joints.size());
    // The body stands, so its loops close.
    places[i] = spring.links->follow<double>(joints, still)->position[spring.place];
  }
  return places;
}

VectorXd RigidSprings::moved(const MatrixXd& rates, const ContactRows& contacts,
                             const VectorXd& by) const {
  VectorXd velocity = VectorXd::Zero(rates.cols());
  if (size() == 0 || undriven_.empty()) return velocity;
  const VectorXd joints = least_move(rates(Eigen::all, undriven_), by);
  velocity(undriven_) = joints;
  const Index base = robot_->tree.base_velocity_size();
  if (base == 0 || contacts.jacobian.rows() == 0) return velocity;
  velocity.head(base) = least_move(contacts.jacobian.leftCols(base),
                                   -(contacts.jacobian(Eigen::all, undriven_) * joints));
  return velocity;
}

}  // namespace torquewright::hopper
