// SPDX-License-Identifier: Apache-2.0
#include "simulation/plants/tree_plant.hpp"

#include <gtest/gtest.h>

#include "simulation/plants/serial_arm.hpp"

namespace torquewright::simulation {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Sums of products of numbers near 1, in another order.
constexpr double kRounding = 1e-12;

const std::vector<dynamics::SerialLink> kLinks = {
    {.mass_kg = 1.3, .length_m = 0.4, .center_of_mass_m = 0.17, .inertia_kg_m2 = 0.021},
    {.mass_kg = 0.8, .length_m = 0.3, .center_of_mass_m = 0.11, .inertia_kg_m2 = 0.012},
    {.mass_kg = 0.5, .length_m = 0.2, .center_of_mass_m = 0.09, .inertia_kg_m2 = 0.003}};

/// The same arm as bodies: 0 hangs down, positive swings towards +x, about -y.
dynamics::Tree tree_of_arm() {
  dynamics::Tree tree;
  tree.bodies.emplace_back().name = "base";
  for (std::size_t i = 0; i < kLinks.size(); ++i) {
    dynamics::Body body;
    body.name = "link";
    body.parent = i;
    body.joint.axis = -Vector3d::UnitY();
    if (i > 0) body.joint.p_PB_m = {0, 0, -kLinks[i - 1].length_m};
    body.inertia.mass_kg = kLinks[i].mass_kg;
    body.inertia.center_of_mass_m = {0, 0, -kLinks[i].center_of_mass_m};
    body.inertia.inertia_kg_m2 = kLinks[i].inertia_kg_m2 * Eigen::Matrix3d::Identity();
    tree.bodies.push_back(body);
  }
  return tree;
}

// Oracle: the closed equations of a planar arm, which share no line with the tree's.
TEST(TreePlant, IsTheArmOfTheClosedEquations) {
  SerialArm arm(kLinks, dynamics::kGravity_m_s2);
  TreePlant plant(tree_of_arm(), {1, 2, 3}, VectorXd::Zero(3));
  const VectorXd position = (VectorXd(3) << 0.4, -0.9, 1.3).finished();
  const VectorXd speed = (VectorXd(3) << 1.1, 2.3, -0.7).finished();
  MatrixXd of_arm(3, 3), of_tree(3, 3);
  arm.mass_matrix(position, of_arm);
  plant.mass_matrix(position, of_tree);
  EXPECT_LT((of_arm - of_tree).cwiseAbs().maxCoeff(), kRounding);
  VectorXd arm_Nm(3), tree_Nm(3);
  arm.bias(position, speed, arm_Nm);
  plant.bias(position, speed, tree_Nm);
  EXPECT_LT((arm_Nm - tree_Nm).cwiseAbs().maxCoeff(), kRounding);
  const VectorXd still = VectorXd::Zero(3);
  const double rise_J = arm.energy_J(position, speed) - arm.energy_J(still, still);
  EXPECT_NEAR(plant.energy_J(position, speed) - plant.energy_J(still, still), rise_J, kRounding);
}

// Oracle: plants that stood nowhere before. Nothing of the places of before is left in a plant that
// moves on, whatever was asked of it there.
TEST(TreePlant, ForgetsWhereItStood) {
  TreePlant plant(tree_of_arm(), {1, 2, 3}, VectorXd::Zero(3));
  const VectorXd speed = (VectorXd(3) << 1.1, 2.3, -0.7).finished();
  for (const double angle_rad : {0.4, -0.9, -0.9, 0.4, 0.0}) {
    const VectorXd position = VectorXd::Constant(3, angle_rad);
    TreePlant fresh(tree_of_arm(), {1, 2, 3}, VectorXd::Zero(3));
    MatrixXd own(3, 3), other(3, 3);
    VectorXd own_Nm(3), other_Nm(3);
    plant.bias(position, speed, own_Nm);
    plant.mass_matrix(position, own);
    fresh.mass_matrix(position, other);
    fresh.bias(position, speed, other_Nm);
    EXPECT_EQ(own, other) << angle_rad;
    EXPECT_EQ(own_Nm, other_Nm) << angle_rad;
  }
}

// Oracle: the same closed equations, with the middle joint's rows left out.
TEST(TreePlant, HoldsTheJointsThatDoNotMove) {
  SerialArm arm(kLinks, dynamics::kGravity_m_s2);
  TreePlant plant(tree_of_arm(), {3, 1}, (VectorXd(3) << 0.0, -0.9, 0.0).finished());
  const VectorXd all = (VectorXd(3) << 0.4, -0.9, 1.3).finished();
  const VectorXd all_speed = (VectorXd(3) << 1.1, 0.0, -0.7).finished();
  MatrixXd of_arm(3, 3), mass(2, 2);
  arm.mass_matrix(all, of_arm);
  plant.mass_matrix((VectorXd(2) << 1.3, 0.4).finished(), mass);
  EXPECT_NEAR(mass(0, 0), of_arm(2, 2), kRounding);
  EXPECT_NEAR(mass(0, 1), of_arm(2, 0), kRounding);
  EXPECT_NEAR(mass(1, 1), of_arm(0, 0), kRounding);
  VectorXd arm_Nm(3), torque_Nm(2);
  arm.bias(all, all_speed, arm_Nm);
  plant.bias((VectorXd(2) << 1.3, 0.4).finished(), (VectorXd(2) << -0.7, 1.1).finished(),
             torque_Nm);
  EXPECT_NEAR(torque_Nm[0], arm_Nm[2], kRounding);
  EXPECT_NEAR(torque_Nm[1], arm_Nm[0], kRounding);
}

TEST(TreePlant, RefusesWhatIsNoPlant) {
  dynamics::Tree floating = tree_of_arm();
  floating.base = dynamics::BaseKind::kSpatial;
  EXPECT_THROW(TreePlant(floating, {1}, VectorXd::Zero(10)), std::invalid_argument);
  EXPECT_THROW(TreePlant(tree_of_arm(), {1, 1}, VectorXd::Zero(3)), std::invalid_argument);
  EXPECT_THROW(TreePlant(tree_of_arm(), {4}, VectorXd::Zero(3)), std::invalid_argument);
  EXPECT_THROW(TreePlant(tree_of_arm(), {1}, VectorXd::Zero(2)), std::invalid_argument);
}

}  // namespace
}  // namespace torquewright::simulation
