// SPDX-License-Identifier: Apache-2.0
// Oracles: a potential, whose slopes by differences the gains' forces are; power, which damping
// only takes; arithmetic of the default gains.
#include "hopper/tracking/pd.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "dynamics/position_step.hpp"
#include "hopper/tracking/drive_loops.hpp"
#include "hopper/tracking/linearisation.hpp"
#include "tests/hopper/tracking/closed_loop.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

class Pd : public testing::Test {
 protected:
  VectorXd drives_rad(const VectorXd& position) {
    EXPECT_TRUE(body.set(position, VectorXd::Zero(9)));
    std::vector<DriveInstant> drives;
    body.drives(VectorXd::Zero(9), VectorXd::Zero(9), drives);
    return (VectorXd(3) << drives[0].position_rad, drives[1].position_rad, drives[2].position_rad)
        .finished();
  }
  /// What the controller adds to the torques of the reference.
  VectorXd added_Nm(Controller& pd, const VectorXd& position, const VectorXd& velocity) const {
    VectorXd torque_Nm;
    pd.start();
    pd.control({0.0, 0.0, 0.0, position, velocity, TouchingPoints::Constant(4, true)}, torque_Nm);
    return torque_Nm - wanted.drive_Nm;
  }

  Robot robot = test::robot_of("hopper.json");
  Reference reference = test::standing(robot, test::crouch(robot), 1.0);
  WholeBody body{robot};
  ReferenceInstant wanted;
  PdOptions options;
  VectorXd bent;

  void SetUp() override {
    reference.at(0.0, wanted);
    options.stiffness_Nm_rad = (VectorXd(3) << 500, 300, 200).finished();
    options.damping_Nm_s_rad = (VectorXd(3) << 30, 4, 5).finished();
    bent = wanted.position;
    bent.tail(3) += (VectorXd(3) << 0.05, -0.1, 0.15).finished();
  }
};

// Joint forces are minus the slopes of k (difference of drives)^2/2: the mechanisms' transposed
// Jacobians, by virtual work.
TEST_F(Pd, StiffnessHasThePotentialOfTheDrivesSprings) {
  const auto pd = pd_controller(robot, reference, options, {}, {ImpactHandling::kDefault});
  const auto potential_J = [&](const VectorXd& at) {
    const VectorXd apart = drives_rad(at) - drives_rad(wanted.position);
    return 0.5 * apart.dot(options.stiffness_Nm_rad.cwiseProduct(apart));
  };
  const VectorXd torque_Nm = added_Nm(*pd, bent, VectorXd::Zero(9));
  ASSERT_TRUE(body.set(bent, VectorXd::Zero(9)));
  const VectorXd force = drive_jacobian(body).transpose() * torque_Nm;
  constexpr double kStep = 1e-5;
  for (Index i = 0; i < 9; ++i) {
    VectorXd ahead(10), behind(10);
    dynamics::step_position(robot.tree, bent, VectorXd::Unit(9, i), kStep, ahead);
    dynamics::step_position(robot.tree, bent, VectorXd::Unit(9, i), -kStep, behind);
    const double slope = (potential_J(ahead) - potential_J(behind)) / (2.0 * kStep);
    EXPECT_NEAR(force[i], -slope, 1e-7 * force.norm()) << i;
  }
  EXPECT_GT(force.norm(), 10.0);
}

TEST_F(Pd, DampingTakesPower) {
  options.stiffness_Nm_rad.setZero();
  const auto pd = pd_controller(robot, reference, options, {}, {ImpactHandling::kDefault});
  VectorXd velocity = VectorXd::Zero(9);
  velocity.tail(3) << 1.0, -2.0, 3.0;
  const VectorXd torque_Nm = added_Nm(*pd, bent, velocity);
  ASSERT_TRUE(body.set(bent, velocity));
  VectorXd speeds_rad_s(3);
  body.speed_changes(velocity, speeds_rad_s);
  const double taken_W = speeds_rad_s.dot(options.damping_Nm_s_rad.cwiseProduct(speeds_rad_s));
  EXPECT_NEAR(torque_Nm.dot(speeds_rad_s), -taken_W, 1e-12 * taken_W);
}

TEST_F(Pd, AddsNothingWhereAllIsAsPlanned) {
  const auto pd = pd_controller(robot, reference, {}, {}, {});
  EXPECT_LT(added_Nm(*pd, wanted.position, wanted.velocity).norm(), 1e-12);
}

// The documents' peaks are 320 and 176 Nm; the gains' own loop in the air, drive by drive, is
// critically damped: d^2 = 4 k I.
TEST_F(Pd, DefaultGainsAreThoseOfPeakTorqueAndLeastInertia) {
  const PdGains gains = pd_gains(robot, reference, {});
  const VectorXd peaks_Nm = (VectorXd(3) << 320, 176, 176).finished();
  for (Index i = 0; i < 3; ++i) {
    EXPECT_NEAR(gains.stiffness_Nm_rad[i], peaks_Nm[i] / 0.5, 0.02 * peaks_Nm[i] / 0.5);
  }
  ASSERT_TRUE(body.set(wanted.position, wanted.velocity));
  Eigen::MatrixXd mass(9, 9);
  body.mass_matrix(mass);
  for (Index i = 0; i < 3; ++i) {
    const Eigen::RowVectorXd drive = drive_jacobian(body).row(i);
    const double inertia_kg_m2 = 1.0 / (drive * mass.inverse() * drive.transpose())(0, 0);
    EXPECT_GE(inertia_kg_m2, body.rotor_inertia_kg_m2(static_cast<std::size_t>(i)));
    const double damping = gains.damping_Nm_s_rad[i];
    EXPECT_NEAR(damping * damping, 4.0 * gains.stiffness_Nm_rad[i] * inertia_kg_m2,
                1e-9 * damping * damping);
  }
}

TEST_F(Pd, RefusesGainsThatAreNone) {
  for (const double wrong : {-1.0, std::nan("")}) {
    PdOptions bad;
    bad.stiffness_Nm_rad = VectorXd::Constant(3, wrong);
    EXPECT_THROW((void)pd_gains(robot, reference, bad), std::invalid_argument);
  }
  PdOptions two;
  two.damping_Nm_s_rad = VectorXd::Ones(2);
  EXPECT_THROW((void)pd_gains(robot, reference, two), std::invalid_argument);
  PdOptions none;
  none.full_torque_error_rad = 0.0;
  EXPECT_THROW((void)pd_gains(robot, reference, none), std::invalid_argument);
}

}  // namespace
}  // namespace torquewright::hopper
