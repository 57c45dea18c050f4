// SPDX-License-Identifier: Apache-2.0
// Oracles: identities of mechanics, each between parts that share no formula.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/mass_matrix.hpp"
#include "dynamics/momentum.hpp"
#include "dynamics/point.hpp"
#include "dynamics/position_step.hpp"
#include "tests/dynamics/random_tree.hpp"

namespace torquewright::dynamics {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using oracles::Dice;
using test::difference;
using test::uniform_vector;
using Matrix3X = Eigen::Matrix<double, 3, Eigen::Dynamic>;

constexpr double kIdentityRoundOff = 1e-11;  // a few hundred roundings, scaled to 1
constexpr double kStep = 6e-6;               // cube root of the machine's epsilon
constexpr double kDifference = 1e-7;  // of central differences of that step, values up to 100

/// A random tree at a random state, rotors' spin included.
struct Sample {
  explicit Sample(std::uint64_t seed)
      : dice(seed), state(spun(dice, static_cast<BaseKind>(seed % 3))) {
    position = test::random_position(dice, state.tree());
    if (state.tree().base == BaseKind::kSpatial) position.segment<4>(3).normalize();
    velocity = uniform_vector(dice, size(), 8);
    state.set(position, velocity);
  }
  static Tree spun(Dice& dice, BaseKind base) {
    Tree tree = test::random_tree(dice, base, 7);
    for (Body& body : tree.bodies) body.joint.rotor_spin_kg_m2 = uniform_vector(dice, 3, 0.05);
    return tree;
  }
  Eigen::Index size() const { return state.velocity().size(); }
  std::size_t any_body() {
    return static_cast<std::size_t>(
        dice.between(0, static_cast<int>(state.tree().bodies.size()) - 1));
  }
  VectorXd any_velocity() { return uniform_vector(dice, size(), 8); }
  /// The same velocity a little later or earlier.
  TreeState moved(const VectorXd& along, double duration_s) const {
    VectorXd there(position.size());
    step_position(state.tree(), position, along, duration_s, there);
    TreeState result = state;
    result.set(there, velocity);
    return result;
  }
  Dice dice;
  TreeState state;
  VectorXd position;
  VectorXd velocity;
};

class TreeIdentity : public testing::TestWithParam<int> {
 protected:
  Sample sample{static_cast<std::uint64_t>(GetParam())};
};

TEST_P(TreeIdentity, ForceIsMassTimesAccelerationPlusBias) {
  MatrixXd mass(sample.size(), sample.size());
  VectorXd force(sample.size());
  VectorXd held(sample.size());
  VectorXd again(sample.size());
  const VectorXd a = uniform_vector(sample.dice, sample.size(), 50);
  mass_matrix(sample.state, mass);
  bias(sample.state, held);
  inverse_dynamics(sample.state, a, force);
  EXPECT_LE(difference(mass * a + held, force), kIdentityRoundOff);
  ASSERT_TRUE(forward_dynamics(sample.state, force, again));
  EXPECT_LE(difference(again, a), 1e-8);  // M's condition is up to 1e4
}

TEST_P(TreeIdentity, KineticEnergyIsTheQuadraticFormOfTheMassMatrix) {
  MatrixXd mass(sample.size(), sample.size());
  mass_matrix(sample.state, mass);
  const double form_J = 0.5 * sample.velocity.dot(mass * sample.velocity);
  EXPECT_NEAR(kinetic_energy_J(sample.state), form_J, kIdentityRoundOff * form_J);
}

// Power in is the rate of kinetic and potential energy. Along the motion that has this velocity and
// acceleration at this moment.
TEST_P(TreeIdentity, PowerIsTheRateOfEnergy) {
  const VectorXd a = uniform_vector(sample.dice, sample.size(), 5);
  VectorXd force(sample.size());
  inverse_dynamics(sample.state, a, force);
  const auto energy_J = [&](double time_s) {
    VectorXd there(sample.position.size());
    step_position(sample.state.tree(), sample.position, sample.velocity + time_s / 2 * a, time_s,
                  there);
    TreeState state = sample.state;
    state.set(there, sample.velocity + time_s * a);
    return kinetic_energy_J(state) + potential_energy_J(state);
  };
  const double rate_W = (energy_J(kStep) - energy_J(-kStep)) / (2 * kStep);
  const double power_W = force.dot(sample.velocity);
  EXPECT_NEAR(power_W, rate_W, kDifference * force.norm() * sample.velocity.norm());
}

TEST_P(TreeIdentity, JacobianIsTheDerivativeOfThePointsPlace) {
  const BodyPoint point{sample.any_body(), uniform_vector(sample.dice, 3, 0.5)};
  Matrix3X jacobian(3, sample.size());
  point_jacobian(sample.state, point, jacobian);
  const VectorXd along = sample.any_velocity();
  const Vector3d slope = (point_position_m(sample.moved(along, kStep), point) -
                          point_position_m(sample.moved(along, -kStep), point)) /
                         (2 * kStep);
  EXPECT_LE(difference(jacobian * along, slope), kDifference);
  EXPECT_LE(difference(jacobian * sample.velocity, point_velocity_m_s(sample.state, point)),
            kIdentityRoundOff);
}

TEST_P(TreeIdentity, BiasAccelerationIsTheRateOfThePointsVelocity) {
  const BodyPoint point{sample.any_body(), uniform_vector(sample.dice, 3, 0.5)};
  const Vector3d slope = (point_velocity_m_s(sample.moved(sample.velocity, kStep), point) -
                          point_velocity_m_s(sample.moved(sample.velocity, -kStep), point)) /
                         (2 * kStep);
  EXPECT_LE(difference(point_bias_acceleration_m_s2(sample.state, point), slope), kDifference);
}

TEST_P(TreeIdentity, RotationJacobianTurnsTheBodysAxes) {
  const std::size_t body = sample.any_body();
  Matrix3X jacobian(3, sample.size());
  rotation_jacobian(sample.state, body, jacobian);
  const VectorXd along = sample.any_velocity();
  const Vector3d turn = jacobian * along;
  const Eigen::Matrix3d slope = (sample.moved(along, kStep).motion(body).R_WB -
                                 sample.moved(along, -kStep).motion(body).R_WB) /
                                (2 * kStep);
  const Eigen::Matrix3d& R = sample.state.motion(body).R_WB;
  for (Eigen::Index k = 0; k < 3; ++k) {
    EXPECT_LE(difference(Vector3d(turn.cross(R.col(k))), Vector3d(slope.col(k))), kDifference);
  }
}

// Virtual work.
TEST_P(TreeIdentity, PointForceActsThroughTheTransposedJacobian) {
  const BodyPoint point{sample.any_body(), uniform_vector(sample.dice, 3, 0.5)};
  const Vector3d force_N = uniform_vector(sample.dice, 3, 90);
  Matrix3X jacobian(3, sample.size());
  point_jacobian(sample.state, point, jacobian);
  VectorXd felt = VectorXd::Ones(sample.size());
  add_point_force(sample.state, point, force_N, felt);
  const VectorXd expected = VectorXd::Ones(sample.size()) + jacobian.transpose() * force_N;
  EXPECT_LE(difference(felt, expected), kIdentityRoundOff);
}

TEST_P(TreeIdentity, CentroidalMomentumMatrixTimesVelocityIsMomentum) {
  MatrixXd matrix(6, sample.size());
  centroidal_momentum_matrix(sample.state, matrix);
  const Centroid whole = centroid(sample.state);
  Eigen::Matrix<double, 6, 1> momentum;
  momentum << whole.angular_momentum_Nm_s, whole.mass_kg * whole.velocity_m_s;
  EXPECT_LE(difference(matrix * sample.velocity, momentum), kIdentityRoundOff);
}

TEST_P(TreeIdentity, CentreOfMassMovesWithItsVelocity) {
  TreeState later = sample.moved(sample.velocity, kStep);
  TreeState earlier = sample.moved(sample.velocity, -kStep);
  const Vector3d slope = (centroid(later).position_m - centroid(earlier).position_m) / (2 * kStep);
  EXPECT_LE(difference(centroid(sample.state).velocity_m_s, slope), kDifference);
}

// A spatial base's rows of forces are the rate of the whole's momentum.
TEST_P(TreeIdentity, ForcesAtTheBaseChangeTheMomentum) {
  sample = Sample(static_cast<std::uint64_t>(3 * GetParam() + 2));  // all six rows: spatial
  const VectorXd a = uniform_vector(sample.dice, sample.size(), 5);
  VectorXd force(sample.size());
  inverse_dynamics(sample.state, a, force);
  const auto momentum_at = [&](double time_s) {
    VectorXd there(sample.position.size());
    step_position(sample.state.tree(), sample.position, sample.velocity + time_s / 2 * a, time_s,
                  there);
    TreeState state = sample.state;
    state.set(there, sample.velocity + time_s * a);
    const Centroid whole = centroid(state);
    Eigen::Matrix<double, 6, 1> momentum;
    momentum << whole.angular_momentum_Nm_s, whole.mass_kg * whole.velocity_m_s;
    return momentum;
  };
  const Eigen::Matrix<double, 6, 1> rate = (momentum_at(kStep) - momentum_at(-kStep)) / (2 * kStep);
  const Centroid whole = centroid(sample.state);
  const Vector3d weight_N(0, 0, -whole.mass_kg * sample.state.tree().gravity_m_s2);
  const Vector3d arm_m = sample.state.base_origin_m() - whole.position_m;
  const Vector3d push_N = force.head<3>();
  const Vector3d moment_Nm = sample.state.motion(0).R_WB * force.segment<3>(3);
  EXPECT_LE(difference(Vector3d(push_N + weight_N), Vector3d(rate.tail<3>())), 1e-6);
  EXPECT_LE(difference(Vector3d(moment_Nm + arm_m.cross(push_N)), Vector3d(rate.head<3>())), 1e-6);
}

TEST_P(TreeIdentity, AverageVelocityHasTheMomentum) {
  const Centroid whole = centroid(sample.state);
  EXPECT_LE(
      difference(whole.inertia_kg_m2 * whole.angular_velocity_rad_s, whole.angular_momentum_Nm_s),
      kIdentityRoundOff);
}

INSTANTIATE_TEST_SUITE_P(Seeds, TreeIdentity, testing::Range(0, 60));

}  // namespace
}  // namespace torquewright::dynamics
