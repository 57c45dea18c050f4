// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/sampled_bench/drive_train.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace torquewright::oracles::sampled {
namespace {

constexpr double kShort_s = 5e-5;
constexpr double kLoop_s = 1e-9;  // the current is what is commanded

Plant free_plant() {
  Plant plant;
  plant.ratio = 10.0;
  plant.load.kind = LoadKind::kFree;
  plant.load.inertia_kg_m2 = 0.04;
  return plant;  // 1 Nm per ampere, 0.05 kg m^2 in all
}

DriveTrain started(const Plant& plant, const Laws& laws) {
  DriveTrain train(plant, laws, kShort_s, kLoop_s);
  train.start(0.0, 0.0, 0.0, kReference_K);
  return train;
}

void run(DriveTrain& train, double command, double time_s) {
  const auto steps = static_cast<int>(std::lround(time_s / kShort_s));
  for (int k = 0; k < steps; ++k) train.advance({.command = command});
}

// Oracle: constant torque less Coulomb friction; w = (T - c) t / J, q = w t / 2. The current rises
// during the first step, which costs half of it.
TEST(SampledDriveTrain, AcceleratesAsConstantTorqueDoes) {
  Laws laws;
  laws.coulomb_positive_Nm = laws.coulomb_negative_Nm = 0.4;
  const Plant plant = free_plant();
  DriveTrain train = started(plant, laws);
  run(train, 1.0, 0.5);
  const double acceleration = (1.0 - 0.4) / plant.moved_kg_m2();
  const double one_step = acceleration * kShort_s;
  EXPECT_NEAR(train.now().speed_rad_s, acceleration * 0.5, 2.0 * one_step);
  EXPECT_NEAR(train.now().angle_rad, acceleration * 0.125, one_step);
}

// Oracle: Coulomb's law. Below breakaway nothing moves, not even creeps.
TEST(SampledDriveTrain, SticksExactlyBelowBreakaway) {
  Laws laws;
  laws.coulomb_positive_Nm = laws.coulomb_negative_Nm = 0.4;
  DriveTrain train = started(free_plant(), laws);
  run(train, 0.399, 0.5);
  EXPECT_EQ(train.now().angle_rad, 0.0);
  run(train, 0.401, 0.5);
  EXPECT_GT(train.now().angle_rad, 0.0);
}

// Oracle: energy. A pendulum without losses keeps potential and kinetic energy.
TEST(SampledDriveTrain, KeepsThePendulumsEnergy) {
  Plant plant = free_plant();
  plant.load.kind = LoadKind::kPendulum;
  plant.load.mass_kg = 1.0;
  plant.load.length_m = 0.3;
  DriveTrain train(plant, {}, kShort_s, kLoop_s);
  train.start(0.0, 1.2, 0.0, kReference_K);
  const double before = -plant.load.gravity_Nm() * std::cos(1.2);
  run(train, 0.0, 5.0);
  const Instant& now = train.now();
  const double after = 0.5 * plant.moved_kg_m2() * now.speed_rad_s * now.speed_rad_s -
                       plant.load.gravity_Nm() * std::cos(now.angle_rad);
  // Second order: some (w h)^2, with w = 5 rad/s, per radian of some 25.
  constexpr double kShare = 1e-5;
  EXPECT_NEAR(after, before, kShare * plant.load.gravity_Nm());
}

// Oracle: at no load the back-EMF equals the voltage; with dead time, the voltage less it.
TEST(SampledDriveTrain, EndsAtNoLoadSpeed) {
  Plant plant = free_plant();
  plant.drive = DriveKind::kWindingVoltage;
  Laws laws;
  laws.viscous_positive_Nm_s_rad = laws.viscous_negative_Nm_s_rad = 0.02;
  laws.dead_time_V = 0.5;
  DriveTrain train = started(plant, laws);
  run(train, 6.0, 2.0);
  // V - dead = R b w / (N Kt) + N Kt w
  const double per_speed = plant.resistance_ohm * 0.02 / plant.Nm_per_A() + plant.Nm_per_A();
  EXPECT_NEAR(train.now().speed_rad_s, (6.0 - 0.5) / per_speed, 1e-5);
}

// Oracle: static balance. A spring between motor and a held output twists by torque over stiffness.
TEST(SampledDriveTrain, TwistsAsItsSpringSays) {
  Plant plant = free_plant();
  plant.load.kind = LoadKind::kImposedSpeed;
  plant.load.inertia_kg_m2 = 0.0;
  Laws laws;
  laws.stiffness_Nm_rad = 200.0;
  laws.damping_Nm_s_rad = 0.6;
  DriveTrain train = started(plant, laws);
  run(train, 3.0, 2.0);
  EXPECT_NEAR(train.now().motor_angle_rad, 3.0 / 200.0, 1e-6);
  EXPECT_NEAR(train.now().torque_Nm, 3.0, 1e-6);
}

// Oracle: play. The motor crosses the gap before the output feels a torque.
TEST(SampledDriveTrain, CrossesTheGapFreely) {
  Plant plant = free_plant();
  plant.load.kind = LoadKind::kImposedSpeed;
  plant.load.inertia_kg_m2 = 0.0;
  Laws laws;
  laws.gap_rad = 0.02;
  laws.stiffness_Nm_rad = 1e5;
  laws.damping_Nm_s_rad = 50.0;
  DriveTrain train = started(plant, laws);
  run(train, 2.0, 1.0);
  EXPECT_NEAR(train.now().motor_angle_rad, 0.01 + 2.0 / 1e5, 1e-7);
  run(train, -2.0, 1.0);
  EXPECT_NEAR(train.now().motor_angle_rad, -0.01 - 2.0 / 1e5, 1e-7);
}

// Oracle: Dahl's law at small angles is a spring.
TEST(SampledDriveTrain, GivesWayBeforeItSlips) {
  Laws laws;
  laws.coulomb_positive_Nm = laws.coulomb_negative_Nm = 1.0;
  laws.presliding_Nm_rad = 100.0;
  laws.viscous_positive_Nm_s_rad = laws.viscous_negative_Nm_s_rad = 10.0;  // no overshoot
  DriveTrain train = started(free_plant(), laws);
  run(train, 0.01, 3.0);
  // F = C (1 - exp(-k x / C)) from rest
  EXPECT_NEAR(train.now().angle_rad, -std::log(1.0 - 0.01) / 100.0, 1e-7);
}

// Oracle: the mesh's definition. Driving, the output gets the efficiency's share; driven back, the
// motor does.
TEST(SampledDriveTrain, LosesInTheMeshEitherWay) {
  Plant plant;
  plant.forward_efficiency = 0.8;
  plant.backward_efficiency = 0.7;
  EXPECT_DOUBLE_EQ(through_mesh_Nm(plant, {}, 10.0, 1.0), 8.0);
  EXPECT_DOUBLE_EQ(through_mesh_Nm(plant, {}, -10.0, 1.0), -10.0 / 0.7);
  Laws laws;
  laws.driving_coefficient = 0.25;
  laws.backdriving_coefficient = 0.2;
  EXPECT_DOUBLE_EQ(through_mesh_Nm(plant, laws, -10.0, -1.0), -8.0 / 1.25);
  EXPECT_DOUBLE_EQ(through_mesh_Nm(plant, laws, 10.0, -1.0), 10.0 / (0.7 * 0.8));
}

// Oracle: two nodes at rest. All copper heat passes both resistances.
TEST(SampledDriveTrain, WarmsToItsThermalResistances) {
  Plant plant = free_plant();
  plant.load.kind = LoadKind::kImposedSpeed;
  plant.heating = {2.0, 3.0, 0.01, 0.02};
  Laws laws;
  laws.resistance_temperature_1_K = 0.0;
  DriveTrain train = started(plant, laws);
  run(train, 4.0, 2.0);
  const double copper_W = plant.resistance_ohm * 16.0;
  EXPECT_NEAR(train.now().case_K - kReference_K, 3.0 * copper_W, 1e-3);
  EXPECT_NEAR(train.now().winding_K - kReference_K, 5.0 * copper_W, 1e-3);
}

}  // namespace
}  // namespace torquewright::oracles::sampled
