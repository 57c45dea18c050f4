// SPDX-License-Identifier: Apache-2.0
// Derivatives of trees. Oracles: fourth-order differences of the double version, and of gradients
// for second derivatives; identities of mechanics that hold but for rounding.
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/jet_functions.hpp"
#include "dynamics/mass_matrix.hpp"
#include "dynamics/momentum.hpp"
#include "dynamics/point.hpp"
#include "dynamics/position_step.hpp"
#include "dynamics/seeds.hpp"
#include "tests/dynamics/random_tree.hpp"

namespace torquewright::dynamics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using oracles::Dice;
using test::difference;
using test::uniform_vector;

constexpr double kIdentityRoundOff = 1e-11;  // a few hundred roundings, scaled to 1
// Differences of step h = 2e-3 leave h^4/30 = 5e-13 of the fifth derivative (turns by 1 rad change
// forces by themselves; v and a enter as polynomials of degree 2 and 1) and eps/h = 1e-13.
constexpr double kStep = 2e-3;
constexpr double kDifference = 1e-9;

/// A random tree, rotors' spin included, of which q, v and a have room in one number.
struct Draw {
  explicit Draw(int seed) : dice(static_cast<std::uint64_t>(seed)) {
    const auto base = static_cast<BaseKind>(seed % 3);
    tree = test::random_tree(dice, base, base == BaseKind::kSpatial ? 3 : 5);
    for (Body& body : tree.bodies) body.joint.rotor_spin_kg_m2 = uniform_vector(dice, 3, 0.05);
    n = tree.velocity_size();
    q = test::random_position(dice, tree);
    if (base == BaseKind::kSpatial) q.segment<4>(3).normalize();
    v = uniform_vector(dice, n, 3);
    a = uniform_vector(dice, n, 9);
    const auto last = static_cast<std::int64_t>(tree.bodies.size()) - 1;
    point = {static_cast<std::size_t>(dice.between(0, last)), Vector3d(uniform_vector(dice, 3, 1))};
    force_N = uniform_vector(dice, 3, 20);
  }
  int size() const { return static_cast<int>(n); }
  Dice dice;
  Tree tree;
  Index n = 0;
  VectorXd q, v, a;
  BodyPoint point;
  Vector3d force_N;
};

/// Inverse dynamics less a contact's force, at displacement, velocity, acceleration (3 n x 1).
template <typename T>
VectorX<T> residual(TreeStateOf<T>& state, const Draw& at, const VectorInOf<T>& x) {
  state.set(displaced<T>(at.tree, at.q, x.head(at.n)), x.segment(at.n, at.n));
  VectorX<T> force(at.n), contact = VectorX<T>::Zero(at.n);
  inverse_dynamics(state, x.tail(at.n), force);
  add_point_force(state, at.point, at.force_N, contact);
  return force - contact;
}

VectorXd variables_of(const Draw& at) {
  VectorXd x(3 * at.n);
  x << VectorXd::Zero(at.n), at.v, at.a;
  return x;
}

template <typename T>
VectorX<T> residual_with_derivatives(const Draw& at) {
  TreeStateOf<T> state(at.tree);
  return residual<T>(state, at, seeded<T>(variables_of(at), 0));
}

template <typename Function>
auto slope_of(const Function& f) {
  using Value = std::decay_t<decltype(f(kStep))>;
  return Value((8 * (f(kStep) - f(-kStep)) - (f(2 * kStep) - f(-2 * kStep))) / (12 * kStep));
}

MatrixXd slopes_of(const VectorX<Jet>& values, int first, int count) {
  MatrixXd slopes(values.size(), count);
  for (Index i = 0; i < values.size(); ++i) {
    for (int j = 0; j < count; ++j) slopes(i, j) = values[i].slope(first + j);
  }
  return slopes;
}

class TreeJet : public testing::TestWithParam<int> {
 protected:
  Draw at{GetParam()};
};

TEST_P(TreeJet, HasTheGradientOfTheDoubleVersion) {
  const VectorX<Jet> r = residual_with_derivatives<Jet>(at);
  const VectorXd x = variables_of(at);
  TreeState state(at.tree);
  MatrixXd expected(at.n, x.size());
  for (Index j = 0; j < x.size(); ++j) {
    expected.col(j) = slope_of([&](double step) -> VectorXd {
      const VectorXd there = x + step * VectorXd::Unit(x.size(), j);
      VectorXd position(at.q.size()), force(at.n), contact = VectorXd::Zero(at.n);
      step_position(at.tree, at.q, there.head(at.n), 1, position);  // not the chart of the jets
      state.set(position, there.segment(at.n, at.n));
      inverse_dynamics(state, there.tail(at.n), force);
      add_point_force(state, at.point, at.force_N, contact);
      return force - contact;
    });
  }
  EXPECT_LE(difference(slopes_of(r, 0, 3 * at.size()), expected), kDifference);
  const VectorXd value = residual<double>(state, at, x);
  VectorXd ours(at.n);
  for (Index i = 0; i < at.n; ++i) ours[i] = r[i].value();
  EXPECT_LE(difference(ours, value), kIdentityRoundOff);
}

TEST_P(TreeJet, HasTheHessianOfItsGradient) {
  const VectorX<Jet2> r = residual_with_derivatives<Jet2>(at);
  const VectorXd x = variables_of(at);
  TreeStateOf<Jet> state(at.tree);
  const int count = 3 * at.size();
  for (int j = 0; j < count; ++j) {
    const MatrixXd expected = slope_of([&](double step) -> MatrixXd {
      const VectorXd there = x + step * VectorXd::Unit(x.size(), j);
      return slopes_of(residual<Jet>(state, at, seeded<Jet>(there, 0)), 0, count);
    });
    MatrixXd ours(at.n, count);
    for (Index i = 0; i < at.n; ++i) {
      for (int k = 0; k < count; ++k) ours(i, k) = r[i].curvature(j, k);
    }
    EXPECT_LE(difference(ours, expected), kDifference);
  }
}

TEST_P(TreeJet, HasTheMassMatrixAsSlopeByAcceleration) {
  const VectorX<Jet2> r = residual_with_derivatives<Jet2>(at);
  TreeState state(at.tree);
  state.set(at.q, at.v);
  MatrixXd mass(at.n, at.n), slopes(at.n, at.n);
  mass_matrix(state, mass);
  const int n = at.size();
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      slopes(i, j) = r[i].slope(2 * n + j);
      for (int k = 0; k < n; ++k) {
        EXPECT_EQ(r[i].curvature(2 * n + j, 2 * n + k), 0);
        EXPECT_EQ(r[i].curvature(2 * n + j, n + k), 0);
      }
    }
  }
  EXPECT_LE(difference(slopes, mass), kIdentityRoundOff);
}

// Quadratic in v: second differences of any step are exact.
TEST_P(TreeJet, IsQuadraticInVelocity) {
  const VectorX<Jet2> r = residual_with_derivatives<Jet2>(at);
  TreeState state(at.tree);
  const auto held = [&](const VectorXd& velocity) {
    VectorXd force(at.n);
    state.set(at.q, velocity);
    bias(state, force);
    return force;
  };
  const int n = at.size();
  for (int j = 0; j < n; ++j) {
    for (int k = 0; k < n; ++k) {
      const VectorXd s = VectorXd::Unit(n, j), t = VectorXd::Unit(n, k);
      const VectorXd expected = held(at.v + s + t) - held(at.v + s) - held(at.v + t) + held(at.v);
      VectorXd ours(n);
      for (int i = 0; i < n; ++i) ours[i] = r[i].curvature(n + j, n + k);
      EXPECT_LE(difference(ours, expected), 1e-9);  // differences of forces of some 1e3
    }
  }
}

// By acceleration and position: slopes of the forces that M times a vector are.
TEST_P(TreeJet, HasTheSlopesOfTheMassMatrixAsMixedSecondDerivatives) {
  const VectorX<Jet2> r = residual_with_derivatives<Jet2>(at);
  TreeStateOf<Jet> state(at.tree);
  state.set(seeded_position<Jet>(at.tree, at.q, 0), VectorX<Jet>::Zero(at.n));
  Eigen::Matrix<Jet, Eigen::Dynamic, Eigen::Dynamic> mass(at.n, at.n);
  mass_matrix(state, mass);
  double off = 0, largest = 1;
  for (int i = 0; i < at.size(); ++i) {
    for (int j = 0; j < at.size(); ++j) {
      for (int k = 0; k < at.size(); ++k) {
        off = std::max(off, std::abs(mass(i, j).slope(k) - r[i].curvature(2 * at.size() + j, k)));
        largest = std::max(largest, std::abs(mass(i, j).slope(k)));
      }
    }
  }
  EXPECT_LE(off, kIdentityRoundOff * largest);
}

// Power: d/dt of the energies is what the forces do; energies share no formula with forces.
TEST_P(TreeJet, GainsTheEnergyThatForcesBring) {
  TreeStateOf<Jet> state(at.tree);
  state.set(seeded_position<Jet>(at.tree, at.q, 0), seeded<Jet>(at.v, at.size()));
  const Jet energy_J = kinetic_energy_J(state) + potential_energy_J(state);
  TreeState plain(at.tree);
  plain.set(at.q, at.v);
  VectorXd force(at.n);
  inverse_dynamics(plain, at.a, force);
  double rate_W = 0;
  for (int k = 0; k < at.size(); ++k) {
    rate_W += energy_J.slope(k) * at.v[k] + energy_J.slope(at.size() + k) * at.a[k];
  }
  EXPECT_NEAR(rate_W, force.dot(at.v), kIdentityRoundOff * (1 + force.norm() * at.v.norm()));
}

TEST_P(TreeJet, HasKineticEnergysCurvatureAsMassMatrix) {
  TreeStateOf<Jet2> state(at.tree);
  state.set(at.q.cast<Jet2>(), seeded<Jet2>(at.v, 0));
  const Jet2 energy_J = kinetic_energy_J(state);
  TreeState plain(at.tree);
  plain.set(at.q, at.v);
  MatrixXd mass(at.n, at.n), curvature(at.n, at.n);
  mass_matrix(plain, mass);
  for (int i = 0; i < at.size(); ++i) {
    for (int j = 0; j < at.size(); ++j) curvature(i, j) = energy_J.curvature(i, j);
  }
  EXPECT_LE(difference(curvature, mass), kIdentityRoundOff);
}

// The weight's potential energy falls with the centre of mass, whose row of the centroidal momentum
// matrix is another formula.
TEST_P(TreeJet, HasTheWeightAsSlopeOfPotentialEnergy) {
  TreeStateOf<Jet> state(at.tree);
  state.set(seeded_position<Jet>(at.tree, at.q, 0), at.v.cast<Jet>());
  const Jet energy_J = potential_energy_J(state);
  Eigen::Matrix<Jet, Eigen::Dynamic, Eigen::Dynamic> momentum(6, at.n);
  centroidal_momentum_matrix(state, momentum);
  for (int k = 0; k < at.size(); ++k) {
    const double weight = at.tree.gravity_m_s2 * momentum(5, k).value();
    EXPECT_NEAR(energy_J.slope(k), weight, kIdentityRoundOff * (1 + std::abs(weight)));
  }
}

TEST_P(TreeJet, MovesPointsAsTheirJacobiansSay) {
  TreeStateOf<Jet> state(at.tree);
  const int n = at.size();
  state.set(seeded_position<Jet>(at.tree, at.q, 0), seeded<Jet>(at.v, n));
  TreeState plain(at.tree);
  plain.set(at.q, at.v);
  Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian(3, n);
  point_jacobian(plain, at.point, jacobian);
  const VectorX<Jet> place_m = point_position_m(state, at.point);
  const VectorX<Jet> speed_m_s = point_velocity_m_s(state, at.point);
  EXPECT_LE(difference(slopes_of(speed_m_s, n, n), jacobian), kIdentityRoundOff);
  // Displacements of a spatial base's origin and its velocity are both in the world's axes.
  EXPECT_LE(difference(slopes_of(place_m, 0, n), jacobian), kIdentityRoundOff);
  const VectorXd carried = slopes_of(speed_m_s, 0, n) * at.v;
  EXPECT_LE(difference(carried, point_bias_acceleration_m_s2(plain, at.point)), kIdentityRoundOff);
  Eigen::Matrix<Jet, 3, Eigen::Dynamic> jets(3, n);
  point_jacobian(state, at.point, jets);
  const Vector3<Jet> product = jets * at.v;  // v fixed: the speed's slopes by position again
  EXPECT_LE(difference(slopes_of(product, 0, n), slopes_of(speed_m_s, 0, n)), kIdentityRoundOff);
}

// A constant force has the potential f.p: without a turning base its forces' slopes are symmetric,
// the second derivatives of f.p.
TEST_P(TreeJet, TurnsAConstantForceAsItsPotentialBends) {
  if (at.tree.base == BaseKind::kSpatial) return;
  TreeStateOf<Jet> state(at.tree);
  state.set(seeded_position<Jet>(at.tree, at.q, 0), at.v.cast<Jet>());
  VectorX<Jet> force = VectorX<Jet>::Zero(at.n);
  add_point_force(state, at.point, at.force_N, force);
  TreeStateOf<Jet2> bent(at.tree);
  bent.set(seeded_position<Jet2>(at.tree, at.q, 0), at.v.cast<Jet2>());
  const Jet2 work_J = point_position_m(bent, at.point).dot(at.force_N);
  MatrixXd curvature(at.n, at.n);
  for (int i = 0; i < at.size(); ++i) {
    for (int j = 0; j < at.size(); ++j) curvature(i, j) = work_J.curvature(i, j);
  }
  EXPECT_LE(difference(slopes_of(force, 0, at.size()), curvature), kIdentityRoundOff);
}

INSTANTIATE_TEST_SUITE_P(Trees, TreeJet, testing::Range(0, 12));

TEST(TreeJet, RefusesSlopesThatAreNotFinite) {
  const Draw at(2);
  TreeStateOf<Jet> state(at.tree);
  VectorX<Jet> velocity = at.v.cast<Jet>();
  EXPECT_NO_THROW(state.set(at.q.cast<Jet>(), velocity));
  velocity[0] = sqrt(Jet::variable(0, 0));
  EXPECT_THROW(state.set(at.q.cast<Jet>(), velocity), std::invalid_argument);
}

}  // namespace
}  // namespace torquewright::dynamics
