// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/mechanisms.md, "Loop".
#include "robot/mechanisms/linked_bodies.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/mass_matrix.hpp"
#include "dynamics/passive_forces.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::MatrixOutOf;
using dynamics::VectorInOf;
using dynamics::VectorOutOf;
using dynamics::VectorX;
using Eigen::Index;

bool is_light(const HeldLoop& held) {
  const LoopGeometry& loop = held.links->geometry();
  return std::all_of(loop.tree.bodies.begin(), loop.tree.bodies.end(),
                     [](const dynamics::Body& body) {
                       return body.inertia.mass_kg == 0 && body.joint.reflected_inertia == 0 &&
                              body.joint.passive.is_none();
                     });
}

std::vector<HeldLoop> those_that_count(std::vector<HeldLoop> loops) {
  loops.erase(std::remove_if(loops.begin(), loops.end(), is_light), loops.end());
  return loops;
}

/// In the robot's tree, where the links of earlier loops are already.
std::size_t whole_index(const dynamics::Tree& tree, const HeldLoop& held, std::size_t first_link,
                        std::size_t in_loop) {
  const auto joints = held.joints.size();
  if (in_loop == 0) return tree.bodies[held.joints.front()].parent;
  if (in_loop <= joints) return held.joints[in_loop - 1];
  return first_link + in_loop - joints - 1;
}

dynamics::Tree with_links(dynamics::Tree tree, const std::vector<HeldLoop>& loops) {
  for (const HeldLoop& held : loops) {
    const std::size_t first = tree.bodies.size();
    const std::vector<dynamics::Body>& bodies = held.links->geometry().tree.bodies;
    for (std::size_t i = held.joints.size() + 1; i < bodies.size(); ++i) {
      dynamics::Body link = bodies[i];
      link.parent = whole_index(tree, held, first, link.parent);
      tree.bodies.push_back(std::move(link));
    }
  }
  return tree;
}

// Of joints whose friction moves the robot's own one by one a single sweep is exact.
constexpr int kMostSweeps = 1000;
constexpr double kSettled = 1e-13;  // of the greatest limit

/// A joint that rests, by what a unit torque in it is at the robot's velocities.
struct RestingJoint {
  Eigen::VectorXd direction;
  double most = 0.0;
  double held = 0.0;
};

/// The torques within limits that leave the least of what is needed, each in turn.
void hold_against(Eigen::VectorXd needed, std::vector<RestingJoint>& resting) {
  double greatest = 0.0;
  for (const RestingJoint& joint : resting) greatest = std::max(greatest, joint.most);
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double change = 0.0;
    for (RestingJoint& joint : resting) {
      const double along = joint.direction.dot(needed) / joint.direction.squaredNorm();
      const double next = std::clamp(joint.held + along, -joint.most, joint.most);
      needed -= (next - joint.held) * joint.direction;
      change = std::max(change, std::abs(next - joint.held));
      joint.held = next;
    }
    if (change <= kSettled * greatest) return;
  }
}

}  // namespace

template <typename T>
LinkedBodiesOf<T>::LinkedBodiesOf(const dynamics::Tree& tree, std::vector<HeldLoop> loops)
    : loops_(those_that_count(std::move(loops))),
      state_(with_links(tree, loops_)),
      size_(tree.velocity_size()) {
  Index row = size_;
  for (const HeldLoop& held : loops_) {
    first_row_.push_back(row);
    row += held.links->geometry().links();
  }
  motions_.setZero(row, size_);
  motions_.topRows(size_).setIdentity();
  bent_.setZero(row);
}

template <typename T>
void LinkedBodiesOf<T>::set(const VectorInOf<T>& position, const VectorInOf<T>& velocity,
                            const std::vector<FollowedOf<T>>& followed) {
  VectorX<T> all(state_.tree().position_size());
  all.head(position.size()) = position;
  bent_.setZero();
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    const Index own = loops_[i].links->geometry().joints,
                links = loops_[i].links->geometry().links();
    const Index row = first_row_[i];
    all.segment(row + position.size() - size_, links) = followed[i].position.tail(links);
    for (Index k = 0; k < own; ++k) {
      const Index column = state_.joint_row(loops_[i].joints[static_cast<std::size_t>(k)]);
      motions_.col(column).segment(row, links) = followed[i].motions.col(k).tail(links);
      bent_.segment(row, links) +=
          followed[i].motions_rate_1_s.col(k).tail(links) * velocity[column];
    }
  }
  const VectorX<T> speeds = motions_ * velocity;
  state_.set(all, speeds);
}

template <typename T>
void LinkedBodiesOf<T>::mass_matrix(MatrixOutOf<T> out) {
  const Index all = motions_.rows();
  Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> mass(all, all);
  dynamics::mass_matrix(state_, mass);
  const Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> moved = mass * motions_;
  out = motions_.transpose() * moved;
}

template <typename T>
void LinkedBodiesOf<T>::inverse_dynamics(const VectorInOf<T>& acceleration, VectorOutOf<T> force) {
  const VectorX<T> rates = motions_ * acceleration + bent_;
  VectorX<T> all(motions_.rows());
  dynamics::inverse_dynamics(state_, rates, all);
  force = motions_.transpose() * all;
}

template <typename T>
void LinkedBodiesOf<T>::add_dampers_and_springs(VectorOutOf<T> force) const {
  VectorX<T> all = VectorX<T>::Zero(motions_.rows());
  dynamics::add_dampers_and_springs(state_, all);
  force += motions_.transpose() * all;
}

template <typename T>
void LinkedBodiesOf<T>::add_dry_friction(
    const dynamics::VectorIn& acceleration,
    dynamics::VectorOut force) const requires std::same_as<T, double> {
  if constexpr (std::same_as<T, double>) {  // Clang 14 makes it for other numbers all the same
    const Eigen::VectorXd rates = motions_ * acceleration + bent_;
    Eigen::VectorXd all = Eigen::VectorXd::Zero(motions_.rows());
    dynamics::add_dry_friction(state_, rates, all);
    force += motions_.transpose() * all;
  }
}

template <typename T>
void LinkedBodiesOf<T>::held_by_friction(
    const dynamics::VectorIn& acceleration, const dynamics::VectorIn& needed,
    dynamics::VectorOut held) const requires std::same_as<T, double> {
  if constexpr (std::same_as<T, double>) {
    const Eigen::VectorXd rates = motions_ * acceleration + bent_;
    const std::vector<dynamics::Body>& bodies = state_.tree().bodies;
    std::vector<RestingJoint> resting;
    for (std::size_t i = 1; i < bodies.size(); ++i) {
      const Index row = state_.joint_row(i);
      const double most = dynamics::friction_limit(bodies[i].joint.passive, 0.0);
      const bool moves = std::abs(state_.joint_velocity(i)) > dynamics::kRest ||
                         std::abs(rates[row]) > dynamics::kRest;
      if (most == 0.0 || moves || motions_.row(row).isZero(0.0)) continue;
      resting.push_back({motions_.row(row).transpose(), most});
    }
    hold_against(needed, resting);
    held.setZero();
    for (const RestingJoint& joint : resting) held += joint.held * joint.direction;
  }
}

template class LinkedBodiesOf<double>;
template class LinkedBodiesOf<dynamics::Jet>;
template class LinkedBodiesOf<dynamics::Jet2>;

}  // namespace torquewright::hopper
