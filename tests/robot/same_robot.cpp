// SPDX-License-Identifier: Apache-2.0
#include "tests/robot/same_robot.hpp"

#include <limits>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/mass_matrix.hpp"
#include "dynamics/passive_forces.hpp"

namespace torquewright::test {

using Eigen::MatrixXd;
using Eigen::VectorXd;

hopper::Robot random_robot(oracles::Dice& dice, dynamics::BaseKind base) {
  hopper::Robot robot;
  robot.name = "random <robot> & \"friends\"";
  robot.tree = random_tree(dice, base, 6);
  for (std::size_t i = 1; i < robot.tree.bodies.size(); ++i) {
    dynamics::Joint& joint = robot.tree.bodies[i].joint;
    joint.name = "joint_" + std::to_string(i);
    if (dice.chance(50)) continue;
    joint.limits = {-uniform(dice, 0.1, 2), uniform(dice, 0.1, 2), 7.5, 120.25};
    joint.passive = {0.3, 1.25, 0, 0, 0};
  }
  robot.contacts.push_back({"tip", {1, {0.1, 0, -0.2}}, 0.6, 0.1});
  return robot;
}

namespace {

void add_passive(const dynamics::TreeState& state, VectorXd& force) {
  dynamics::add_dampers_and_springs(state, force);
  dynamics::add_dry_friction(state, VectorXd::Zero(force.size()), force);
}

}  // namespace

double dynamic_difference(const hopper::Robot& one, const hopper::Robot& other) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const Eigen::Index size = one.tree.velocity_size();
  if (one.tree.base != other.tree.base || other.tree.velocity_size() != size) return kInfinite;
  const Eigen::Index base = one.tree.base_velocity_size();
  MatrixXd swap = MatrixXd::Zero(size, size);  // other's velocity is swap times one's
  swap.topLeftCorner(base, base).setIdentity();
  for (std::size_t i = 1; i < one.tree.bodies.size(); ++i) {
    const auto found = other.find_joint(one.tree.bodies[i].joint.name);
    if (!found) return kInfinite;
    swap(base + static_cast<Eigen::Index>(*found) - 1, base + static_cast<Eigen::Index>(i) - 1) = 1;
  }
  oracles::Dice dice(11);
  dynamics::TreeState first(one.tree);
  dynamics::TreeState second(other.tree);
  double worst = 0;
  for (int sample = 0; sample < 20; ++sample) {
    const VectorXd q = random_position(dice, one.tree);
    const VectorXd v = uniform_vector(dice, size, 5);
    VectorXd swapped = q;
    const Eigen::Index joints = size - base;
    swapped.tail(joints) = swap.bottomRightCorner(joints, joints) * q.tail(joints);
    first.set(q, v);
    second.set(swapped, swap * v);
    MatrixXd mass(size, size);
    MatrixXd other_mass(size, size);
    VectorXd force(size);
    VectorXd other_force(size);
    dynamics::mass_matrix(first, mass);
    dynamics::mass_matrix(second, other_mass);
    dynamics::bias(first, force);
    dynamics::bias(second, other_force);
    add_passive(first, force);
    add_passive(second, other_force);
    worst = std::max(worst, difference(swap.transpose() * other_mass * swap, mass));
    worst = std::max(worst, difference(VectorXd(swap.transpose() * other_force), force));
  }
  return worst;
}

}  // namespace torquewright::test
