// SPDX-License-Identifier: Apache-2.0
// Oracle: every rotor as a body of its own that turns N times as fast as its joint. With the
// constant matrix G, velocities of that larger tree are G v, so its dynamics seen by v are
// G^T M G, G^T h and A G; the rotors' bodies use none of the code for rotors.
#include <gtest/gtest.h>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/mass_matrix.hpp"
#include "dynamics/momentum.hpp"
#include "dynamics/rigid_inertia.hpp"
#include "tests/dynamics/random_tree.hpp"

namespace torquewright::dynamics {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::difference;

constexpr double kRotorRoundOff = 1e-11;
constexpr std::size_t kJoints = 5;

struct Rotor {
  double ratio;
  double spin_inertia_kg_m2;
  Vector3d axis;  // in its carrier
  RigidInertia inertia;
};

Rotor random_rotor(oracles::Dice& dice) {
  const Vector3d axis = test::random_direction(dice);
  const double spin = test::uniform(dice, 1e-3, 1e-2);
  const double across = test::uniform(dice, 0.6, 1) * spin;
  const Eigen::Matrix3d inertia =
      across * Eigen::Matrix3d::Identity() + (spin - across) * axis * axis.transpose();
  return {test::uniform(dice, -12, 12),
          spin,
          axis,
          {0.4, test::uniform_vector(dice, 3, 0.2), 0.5 * (inertia + inertia.transpose())}};
}

/// The rotors of all joints locked to their carriers, their spin in the joints' numbers.
Tree reduced(Tree tree, const std::vector<Rotor>& rotors) {
  for (std::size_t i = 1; i <= kJoints; ++i) {
    const auto& [ratio, spin, axis, inertia] = rotors[i - 1];
    Body& carrier = tree.bodies[tree.bodies[i].parent];
    carrier.inertia = welded(carrier.inertia, inertia);
    tree.bodies[i].joint.reflected_inertia = ratio * ratio * spin;
    tree.bodies[i].joint.rotor_spin_kg_m2 = ratio * spin * axis;
  }
  return tree;
}

Tree with_bodies(Tree tree, const std::vector<Rotor>& rotors) {
  for (std::size_t i = 1; i <= kJoints; ++i) {
    Body rotor{.name = "rotor", .parent = tree.bodies[i].parent, .joint = {}, .inertia = {}};
    rotor.joint.p_PB_m = rotors[i - 1].inertia.center_of_mass_m;
    rotor.joint.axis = rotors[i - 1].axis;
    rotor.inertia = rotors[i - 1].inertia;
    rotor.inertia.center_of_mass_m.setZero();
    tree.bodies.push_back(rotor);
  }
  return tree;
}

TEST(Rotor, IsABodyOfItsOwn) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    oracles::Dice dice(seed);
    Tree plain = test::random_tree(dice, static_cast<BaseKind>(seed % 3), kJoints);
    for (Body& body : plain.bodies) body.joint.reflected_inertia = 0;
    std::vector<Rotor> rotors;
    for (std::size_t i = 0; i < kJoints; ++i) rotors.push_back(random_rotor(dice));
    TreeState ours(reduced(plain, rotors));
    TreeState larger(with_bodies(plain, rotors));
    const Eigen::Index n = ours.velocity().size();
    const auto k = static_cast<Eigen::Index>(kJoints);
    MatrixXd G = MatrixXd::Zero(n + k, n);
    G.topRows(n).setIdentity();
    for (Eigen::Index i = 0; i < k; ++i) {
      G(n + i, n - k + i) = rotors[static_cast<std::size_t>(i)].ratio;
    }
    const VectorXd q = test::random_position(dice, ours.tree());
    const VectorXd v = test::uniform_vector(dice, n, 6);
    const VectorXd a = test::uniform_vector(dice, n, 40);
    VectorXd larger_q(q.size() + k);
    larger_q << q, test::uniform_vector(dice, k, 3);  // where a rotor stands must not matter
    ours.set(q, v);
    larger.set(larger_q, G * v);

    MatrixXd mass(n, n);
    MatrixXd larger_mass(n + k, n + k);
    VectorXd force(n);
    VectorXd larger_force(n + k);
    mass_matrix(ours, mass);
    mass_matrix(larger, larger_mass);
    inverse_dynamics(ours, a, force);
    inverse_dynamics(larger, G * a, larger_force);
    EXPECT_LE(difference(mass, G.transpose() * larger_mass * G), kRotorRoundOff);
    EXPECT_LE(difference(force, G.transpose() * larger_force), kRotorRoundOff);
    EXPECT_LE(
        difference(centroid(ours).angular_momentum_Nm_s, centroid(larger).angular_momentum_Nm_s),
        kRotorRoundOff);
    EXPECT_NEAR(kinetic_energy_J(ours), kinetic_energy_J(larger),
                kRotorRoundOff * kinetic_energy_J(larger));
  }
}

TEST(RigidInertia, WeldsAsTwoBodiesDo) {
  oracles::Dice dice(5);
  const RigidInertia one = test::random_inertia(dice);
  const RigidInertia other = test::random_inertia(dice);
  Tree pair;
  pair.base = BaseKind::kSpatial;
  pair.bodies.push_back({.name = "one", .parent = 0, .joint = {}, .inertia = one});
  const Eigen::Matrix3d R = test::random_rotation(dice);
  const Vector3d p = test::uniform_vector(dice, 3, 0.5);
  Tree whole = pair;
  whole.bodies[0].inertia = welded(one, moved(other, R, p));
  Joint joint;
  joint.R_PB = R;
  joint.p_PB_m = p;
  pair.bodies.push_back({.name = "other", .parent = 0, .joint = joint, .inertia = other});
  TreeState two(pair);
  TreeState welded_one(whole);
  EXPECT_LE(difference(centroid(two).inertia_kg_m2, centroid(welded_one).inertia_kg_m2), 1e-14);
  EXPECT_LE(difference(centroid(two).position_m, centroid(welded_one).position_m), 1e-14);
}

}  // namespace
}  // namespace torquewright::dynamics
