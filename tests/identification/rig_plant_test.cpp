// SPDX-License-Identifier: Apache-2.0
#include "identification/simulated/rig_plant.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "identification/signals/load_model.hpp"

namespace torquewright::identification {
namespace {

// The same sum in another order: some units in the last place of 10 Nm.
constexpr double kRounding_Nm = 1e-13;

Rig rig_of(LoadType type) {
  Rig rig;
  rig.joints = {""};
  rig.load.type = type;
  rig.load.mass_kg = 1.3;
  rig.load.length_m = 0.4;
  rig.load.inertia_kg_m2 = 0.02;
  return rig;
}

/// M(q) a + h(q, v).
Eigen::VectorXd torque_Nm(simulation::Plant& plant, const Eigen::VectorXd& position_rad,
                          const Eigen::VectorXd& speed_rad_s,
                          const Eigen::VectorXd& acceleration_rad_s2) {
  const Eigen::Index joints = plant.joint_count();
  Eigen::MatrixXd mass(joints, joints);
  Eigen::VectorXd bias(joints);
  plant.mass_matrix(position_rad, mass);
  plant.bias(position_rad, speed_rad_s, bias);
  return mass * acceleration_rad_s2 + bias;
}

// Oracle: the load's torque as the equations of the regression state it.
TEST(RigPlant, TakesTheTorqueThatTheRegressionTakesOfIt) {
  for (const LoadType type : {LoadType::kFree, LoadType::kPendulum, LoadType::kLinearAxis}) {
    const Rig rig = rig_of(type);
    Signals signals;
    signals.at.resize(1);
    signals.at[0].output_angle_rad = 0.7;
    signals.at[0].acceleration_rad_s2 = 5.0;
    const Eigen::VectorXd found =
        torque_Nm(*plant_of(rig.load), Eigen::VectorXd::Constant(1, 0.7),
                  Eigen::VectorXd::Constant(1, -2.0), Eigen::VectorXd::Constant(1, 5.0));
    EXPECT_NEAR(found[0], model_load_Nm(rig, 0, signals)[0], kRounding_Nm) << name_of(type);
  }
}

// Oracle: closed form, J a.
TEST(ModelLoad, IsThatOfTheRun) {
  Rig rig = rig_of(LoadType::kFree);
  rig.loads["heavy"] = rig.load;
  rig.loads["heavy"].inertia_kg_m2 = 0.5;
  Signals signals;
  signals.at.resize(1);
  signals.at[0].acceleration_rad_s2 = 5.0;
  EXPECT_DOUBLE_EQ(model_load_Nm(rig, 0, signals)[0], 0.02 * 5.0);
  signals.run_name = "heavy (last third)";
  EXPECT_DOUBLE_EQ(model_load_Nm(rig, 0, signals)[0], 0.5 * 5.0);
}

TEST(RigPlant, IsAnArmWhereTheRigIsOne) {
  Rig rig;
  rig.joints = {"shoulder", "elbow"};
  rig.load.type = LoadType::kSerialArm;
  rig.load.links = {{1.0, 0.3, 0.15, 0.01}, {0.6, 0.25, 0.12, 0.005}};
  const Eigen::Vector2d position(0.3, -0.8), speed(1.5, -2.5), acceleration(4.0, 7.0);
  Signals signals;
  signals.at.resize(1);
  for (const Eigen::Index j : {0, 1}) {
    JointMotion motion;
    motion.position_rad = {position[j]};
    motion.velocity_rad_s = {speed[j]};
    motion.acceleration_rad_s2 = {acceleration[j]};
    signals.arm.push_back(motion);
  }
  const Eigen::VectorXd found = torque_Nm(*plant_of(rig.load), position, speed, acceleration);
  ASSERT_EQ(found.size(), 2);
  for (const std::size_t j : {0u, 1u}) {
    EXPECT_NEAR(found[static_cast<Eigen::Index>(j)], model_load_Nm(rig, j, signals)[0],
                kRounding_Nm)
        << j;
  }
}

TEST(RigPlant, OnlyADynamometerImposesTheMotion) {
  EXPECT_TRUE(plant_of(rig_of(LoadType::kDynamometer).load)->is_imposed());
  EXPECT_EQ(plant_of(rig_of(LoadType::kDynamometer).load)->joint_count(), 1);
  EXPECT_FALSE(plant_of(rig_of(LoadType::kPendulum).load)->is_imposed());
}

}  // namespace
}  // namespace torquewright::identification
