// SPDX-License-Identifier: Apache-2.0
#include "dynamics/serial_arm.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <cmath>
#include <limits>

#include "tests/dynamics/random_arm.hpp"

namespace torquewright::dynamics {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using oracles::Dice;
using test::difference;
using test::random_arm;
using test::uniform_vector;

// A few dozen roundings of numbers that were scaled to 1.
constexpr double kSerialArmRoundOff = 1e-12;

/// What torques make of it; rotors as they reflect at the joints.
VectorXd acceleration(SerialArm& arm, const VectorXd& position_rad, const VectorXd& velocity_rad_s,
                      const VectorXd& torque_Nm, const VectorXd& rotors_kg_m2) {
  const Eigen::Index n = arm.joint_count();
  VectorXd bias_Nm(n);
  MatrixXd mass(n, n);
  arm.bias(position_rad, velocity_rad_s, bias_Nm);
  arm.mass_matrix(position_rad, mass);
  mass.diagonal() += rotors_kg_m2;
  return mass.llt().solve(torque_Nm - bias_Nm);
}

// Oracle: the physical pendulum, (I + m c^2) q'' + m g c sin q = torque.
TEST(SerialArm, OfOneLinkIsAPendulum) {
  SerialArm arm({{.mass_kg = 2, .length_m = 5, .center_of_mass_m = 0.5, .inertia_kg_m2 = 0.1}}, 10);
  const VectorXd q = VectorXd::Constant(1, 0.3);
  VectorXd torque(1);
  arm.inverse_dynamics(q, VectorXd::Constant(1, 4.0), VectorXd::Constant(1, 7.0), torque);
  EXPECT_NEAR(torque[0], 0.6 * 7 + 10 * std::sin(0.3), kSerialArmRoundOff);
  EXPECT_NEAR(arm.potential_energy_J(q), -10 * std::cos(0.3), kSerialArmRoundOff);
  EXPECT_NEAR(arm.kinetic_energy_J(q, VectorXd::Constant(1, 4.0)), 0.3 * 16, kSerialArmRoundOff);
}

// Oracle: Lagrange's equations of two links written out, the textbook's M, C and g (planar elbow
// arm in relative angles), with gravity for angles from hanging down.
TEST(SerialArm, OfTwoLinksIsTheDoublePendulum) {
  Dice dice(61);
  for (int sample = 0; sample < 1000; ++sample) {
    SerialArm arm = random_arm(dice, 2);
    const auto [m1, l1, c1, I1] = arm.links()[0];
    const auto [m2, l2, c2, I2] = arm.links()[1];
    const VectorXd q = uniform_vector(dice, 2, 4);
    const VectorXd v = uniform_vector(dice, 2, 9);
    const double cross = m2 * l1 * c2;
    MatrixXd mass(2, 2);
    mass(1, 1) = I2 + m2 * c2 * c2;
    mass(0, 1) = mass(1, 0) = mass(1, 1) + cross * std::cos(q[1]);
    mass(0, 0) = I1 + m1 * c1 * c1 + m2 * l1 * l1 + mass(0, 1) + cross * std::cos(q[1]);
    const double g2 = 9.81 * m2 * c2 * std::sin(q[0] + q[1]);
    const double g1 = 9.81 * (m1 * c1 + m2 * l1) * std::sin(q[0]) + g2;
    const double swing = cross * std::sin(q[1]);
    const Eigen::Vector2d bias(-swing * (2 * v[0] * v[1] + v[1] * v[1]) + g1,
                               swing * v[0] * v[0] + g2);
    MatrixXd ours(2, 2);
    VectorXd ours_bias(2);
    arm.mass_matrix(q, ours);
    arm.bias(q, v, ours_bias);
    ASSERT_LE(difference(ours, mass), kSerialArmRoundOff);
    ASSERT_LE(difference(ours_bias, bias), kSerialArmRoundOff);
  }
}

// Oracle: the other derivation; eq. (4) against eqs. (5)-(7) at v = 0 without gravity's share.
TEST(SerialArm, MassMatrixIsTheColumnsOfInverseDynamics) {
  Dice dice(62);
  for (Eigen::Index joints = 1; joints <= 6; ++joints) {
    SerialArm arm = random_arm(dice, joints);
    const VectorXd q = uniform_vector(dice, joints, 4);
    const VectorXd v = uniform_vector(dice, joints, 9);
    const VectorXd a = uniform_vector(dice, joints, 50);
    MatrixXd mass(joints, joints);
    VectorXd torque(joints);
    VectorXd bias(joints);
    arm.mass_matrix(q, mass);
    arm.inverse_dynamics(q, v, a, torque);
    arm.bias(q, v, bias);
    EXPECT_LE(difference(mass * a + bias, torque), kSerialArmRoundOff) << joints << " joints";
  }
}

// Oracle: eq. (8), a point mass at a joint belongs to either link.
TEST(SerialArm, RegressorKnowsThatAMassAtAJointBelongsToEitherLink) {
  Dice dice(63);
  SerialArm arm = random_arm(dice, 4);
  MatrixXd columns(4, 12);
  arm.regressor(uniform_vector(dice, 4, 4), uniform_vector(dice, 4, 9), uniform_vector(dice, 4, 9),
                columns);
  EXPECT_EQ(columns.col(0).cwiseAbs().maxCoeff(), 0);
  for (Eigen::Index i = 1; i < 4; ++i) {
    const double length_m = arm.links()[static_cast<std::size_t>(i - 1)].length_m;
    const VectorXd before = columns.col(3 * i - 3) + length_m * columns.col(3 * i - 2) +
                            length_m * length_m * columns.col(3 * i - 1);
    EXPECT_LE(difference(columns.col(3 * i), before), kSerialArmRoundOff) << i;
  }
}

TEST(SerialArm, RegressorHasTwoBaseParametersPerLinkAndNoMore) {
  Dice dice(64);
  SerialArm arm = random_arm(dice, 3);
  MatrixXd stacked(3 * 40, 9);
  MatrixXd columns(3, 9);
  for (Eigen::Index sample = 0; sample < 40; ++sample) {
    arm.regressor(uniform_vector(dice, 3, 4), uniform_vector(dice, 3, 9),
                  uniform_vector(dice, 3, 9), columns);
    stacked.middleRows(3 * sample, 3) = columns;
  }
  EXPECT_EQ(Eigen::ColPivHouseholderQR<MatrixXd>(stacked).rank(), 6);
}

TEST(SerialArm, RegressorDoesNotUseWhatItMultiplies) {
  Dice dice(65);
  SerialArm arm = random_arm(dice, 3);
  std::vector<SerialLink> heavy(arm.links().begin(), arm.links().end());
  for (SerialLink& link : heavy) link.mass_kg *= 3, link.inertia_kg_m2 += 1;
  SerialArm other(heavy);
  const VectorXd q = uniform_vector(dice, 3, 4);
  MatrixXd columns(3, 9);
  MatrixXd same(3, 9);
  arm.regressor(q, q, q, columns);
  other.regressor(q, q, q, same);
  EXPECT_EQ(columns, same);
}

TEST(SerialArm, MassAndBiasUndoInverseDynamics) {
  Dice dice(66);
  for (int sample = 0; sample < 200; ++sample) {
    const Eigen::Index joints = 1 + sample % 5;
    SerialArm arm = random_arm(dice, joints);
    const VectorXd q = uniform_vector(dice, joints, 4);
    const VectorXd v = uniform_vector(dice, joints, 9);
    const VectorXd a = uniform_vector(dice, joints, 50);
    const VectorXd rotors = VectorXd::Constant(joints, 0.02);
    VectorXd torque(joints);
    arm.inverse_dynamics(q, v, a, torque);
    torque += rotors.cwiseProduct(a);
    const VectorXd again = acceleration(arm, q, v, torque, rotors);
    ASSERT_LE(difference(again, a), 1e-9);  // M's condition: up to 1e3
  }
}

/// Energy after one second without torques by fourth-order Runge-Kutta, minus that before.
double energy_drift_J(SerialArm arm, int steps) {
  const Eigen::Index n = arm.joint_count();
  VectorXd q = VectorXd::LinSpaced(n, 1.0, 2.0);
  VectorXd v = VectorXd::Constant(n, 1.0);
  const VectorXd zero = VectorXd::Zero(n);
  const auto slope = [&](const VectorXd& at_q, const VectorXd& at_v) {
    return acceleration(arm, at_q, at_v, zero, zero);
  };
  const double before_J = arm.kinetic_energy_J(q, v) + arm.potential_energy_J(q);
  const double h = 1.0 / steps;
  for (int step = 0; step < steps; ++step) {
    const VectorXd a1 = slope(q, v);
    const VectorXd v2 = v + h / 2 * a1;
    const VectorXd a2 = slope(q + h / 2 * v, v2);
    const VectorXd v3 = v + h / 2 * a2;
    const VectorXd a3 = slope(q + h / 2 * v2, v3);
    const VectorXd v4 = v + h * a3;
    const VectorXd a4 = slope(q + h * v3, v4);
    q += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return arm.kinetic_energy_J(q, v) + arm.potential_energy_J(q) - before_J;
}

// Oracle: conservation; what is left is the integrator's, and falls at least by its order.
TEST(SerialArm, ConservesEnergyWithoutTorques) {
  const SerialArm arm({{2, 0.4, 0.2, 0.03}, {1, 0.3, 0.1, 0.01}, {0.5, 0.2, 0.15, 0.005}});
  const double coarse_J = energy_drift_J(arm, 1000);
  const double fine_J = energy_drift_J(arm, 2000);
  EXPECT_LE(std::abs(fine_J), 1e-6);
  EXPECT_LE(std::abs(fine_J), std::abs(coarse_J) / 12);
}

TEST(SerialArm, RefusesWhatItCannotBe) {
  EXPECT_THROW(SerialArm({}), std::invalid_argument);
  EXPECT_THROW(SerialArm({{1, 1, std::numeric_limits<double>::quiet_NaN(), 1}}),
               std::invalid_argument);
  SerialArm arm({{1, 1, 1, 1}, {1, 1, 1, 1}});
  VectorXd two = VectorXd::Zero(2);
  const VectorXd three = VectorXd::Zero(3);
  EXPECT_THROW(arm.bias(two, three, two), std::invalid_argument);
  EXPECT_THROW(arm.potential_energy_J(three), std::invalid_argument);
  MatrixXd wrong(2, 3);
  EXPECT_THROW(arm.mass_matrix(two, wrong), std::invalid_argument);
  EXPECT_THROW(arm.regressor(two, two, two, wrong), std::invalid_argument);
}

}  // namespace
}  // namespace torquewright::dynamics
