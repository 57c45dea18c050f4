// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "tests/oracles/robot_bench/documents.hpp"
#include "tests/oracles/robot_bench/missing.hpp"
#include "tests/oracles/robot_bench/motions.hpp"
#include "tests/oracles/robot_bench/robots.hpp"

namespace torquewright::oracles::robot_bench {
namespace {

constexpr double kMass_kg = 1.3, kLever_m = 0.25, kInertia_kg_m2 = 0.01, kArmature_kg_m2 = 0.02;
constexpr double kGravity_m_s2 = 9.81;
/// Of robots with few joints, where there are no public models.
constexpr std::uint64_t kNoneSeed = 6, kOneSeed = 5;
constexpr double kAboutJoint_kg_m2 =
    kInertia_kg_m2 + kMass_kg * kLever_m * kLever_m + kArmature_kg_m2;
constexpr double kWeight_Nm = kMass_kg * kGravity_m_s2 * kLever_m;

/// One link that hangs down; about z it swings without weight.
Scene one_joint(const Eigen::Vector3d& axis) {
  Scene scene;
  scene.robot.name = "one joint";
  scene.robot.base = "base";
  scene.robot.bodies = {
      {"base", 1, {0, 0, 0}, 0.01 * Eigen::Matrix3d::Identity()},
      {"link", kMass_kg,
       axis.z() == 0 ? Eigen::Vector3d(0, 0, -kLever_m) : Eigen::Vector3d(kLever_m, 0, 0),
       kInertia_kg_m2 * Eigen::Matrix3d::Identity()}};
  Joint joint;
  joint.name = "swing";
  joint.parent = "base";
  joint.child = "link";
  joint.axis = axis;
  scene.robot.joints = {joint};
  scene.laws["swing"].armature_kg_m2 = kArmature_kg_m2;
  scene.controllers["swing"] = {0, 0, kNever};
  return scene;
}

Commands ramp(double from_rad, double to_rad, double duration_s) {
  Commands commands;
  commands.packet_s = 0.001;
  commands.targets_rad.resize(1);
  const auto packets = static_cast<std::size_t>(std::lround(duration_s / 0.001));
  for (std::size_t k = 0; k < packets; ++k)
    commands.targets_rad[0].push_back(from_rad + (to_rad - from_rad) * static_cast<double>(k) /
                                                     static_cast<double>(packets));
  return commands;
}

// Closed form: T = 2 pi sqrt(I / (m g l)) (1 + A^2 / 16 + 11 A^4 / 3072) of a pendulum with its
// rotor's inertia.
TEST(RobotBenchPlant, PendulumHasItsPeriod) {
  const double amplitude = 0.5, step_s = 1e-4;
  const Scene scene = one_joint(Eigen::Vector3d::UnitY());
  Plant plant(scene, step_s);
  plant.start_at({amplitude});
  std::vector<double> crossings_s;
  double before = plant.measured_rad(0);
  for (int k = 1; crossings_s.size() < 5; ++k) {
    plant.step({0});
    const double now = plant.measured_rad(0);
    if (before > 0 && now <= 0) crossings_s.push_back(step_s * (k - now / (now - before)));
    before = now;
  }
  const double a2 = amplitude * amplitude;
  const double period = 2 * std::numbers::pi * std::sqrt(kAboutJoint_kg_m2 / kWeight_Nm) *
                        (1 + a2 / 16 + 11 * a2 * a2 / 3072);
  // The next term of the series is 173/737280 A^6, 4e-6 of the period; steps add h^2.
  EXPECT_NEAR((crossings_s[4] - crossings_s[0]) / 4, period, 1e-5 * period);
}

double energy_drift(double step_s) {
  Draws draws(4);
  Scene scene;
  scene.robot = drawn_arm(draws, 3);
  for (const std::string& name : scene.robot.moved()) {
    scene.laws[name].armature_kg_m2 = 0.005;
    scene.controllers[name] = {0, 0, kNever};
  }
  Plant plant(scene, step_s);
  plant.start_at({0.3, 0.9, -0.7});
  const auto total = [&] {
    const Energy energy = plant.energy();
    return energy.kinetic_J + energy.potential_J;
  };
  const double start = total();
  double most = 0, kinetic = 0;
  for (int k = 0; k < std::lround(1 / step_s); ++k) {
    plant.step({0, 0, 0});
    most = std::max(most, std::abs(total() - start));
    kinetic = std::max(kinetic, plant.energy().kinetic_J);
  }
  return most / kinetic;
}

// Conservation: an arm that nothing drives and nothing brakes keeps its energy; of a method of the
// first order what is lost goes with the step.
TEST(RobotBenchPlant, FreeArmKeepsItsEnergy) {
  const double coarse = energy_drift(4e-4), fine = energy_drift(2e-4);
  EXPECT_LT(coarse, 0.01);
  EXPECT_NEAR(coarse / fine, 2, 0.3);
}

// Convergence: what the steps leave is a small part of the finest encoder's noise, so that "none"
// lacks nothing; packets come at instants that no step meets.
TEST(RobotBenchPlant, StepsAreFineEnough) {
  Scene scene = one_joint(Eigen::Vector3d::UnitY());
  scene.controllers["swing"] = {150, 6, kNever};
  scene.laws["swing"].viscous_Nm_s_rad[0] = scene.laws["swing"].viscous_Nm_s_rad[1] = 0.1;
  Draws draws(3);
  Commands commands = draw_motion(draws, scene.robot, 1.5, 0.005, 1);
  commands.delay_s = 0.00317;
  const Record coarse = play(scene, commands, 0.01), fine = play(scene, commands, 0.01, 8);
  const double finest_floor_rad = 2 * std::numbers::pi / 65536 / std::sqrt(12);
  for (std::size_t k = 0; k < coarse.time_s.size(); ++k)
    EXPECT_NEAR(coarse.position_rad[0][k], fine.position_rad[0][k], 0.1 * finest_floor_rad);
}

// Closed form: the loop holds k (c - q) = m g l sin q.
TEST(RobotBenchPlant, LoopSagsUnderWeight) {
  Scene scene = one_joint(Eigen::Vector3d::UnitY());
  scene.controllers["swing"] = {20, 2, kNever};
  const Record record = play(scene, ramp(1.2, 1.2, 2), 0.01);
  const double q = record.position_rad[0].back();
  EXPECT_NEAR(20 * (1.2 - q), kWeight_Nm * std::sin(q), 1e-6);
}

// Closed form: dry friction takes F / I of the speed each second, until the joint rests; then it
// stays.
TEST(RobotBenchPlant, DryFrictionStopsTheJoint) {
  Scene scene = one_joint(Eigen::Vector3d::UnitZ());
  scene.laws["swing"].coulomb_Nm[0] = scene.laws["swing"].coulomb_Nm[1] = 2;
  scene.laws["swing"].upper = {50, 1.0};  // throws it back
  Plant plant(scene, 1e-4);
  plant.start_at({1.3});
  double top = 0;
  for (int k = 0; k < 5000 && plant.measured_rad(0) > 0.99; ++k) {
    plant.step({0});
    top = plant.measured_rad_s(0);
  }
  const double rate = 2 / kAboutJoint_kg_m2, at = plant.measured_rad(0);
  for (int k = 0; k < 1000; ++k) plant.step({0});
  EXPECT_NEAR(plant.measured_rad_s(0), top + 0.1 * rate, 1e-3 * std::abs(top));
  for (int k = 0; k < 20000; ++k) plant.step({0});
  EXPECT_LT(std::abs(plant.measured_rad_s(0)), 1e-9);
  EXPECT_NEAR(at - plant.measured_rad(0), top * top / (2 * rate), 2e-3);
}

// Closed form: slowly lifted, the motor gives (1 + k_d) of the weight; slowly lowered, (1 - k_b).
TEST(RobotBenchPlant, LoadFrictionGoesWithTheWeight) {
  Scene scene = one_joint(Eigen::Vector3d::UnitY());
  scene.controllers["swing"] = {200, 10, kNever};
  scene.laws["swing"].driving_coefficient = 0.2;
  scene.laws["swing"].backdriving_coefficient = 0.1;
  for (const auto& [to, share] : {std::pair{1.2, 1.2}, {0.8, 0.9}}) {
    const Record record = play(scene, ramp(1.0, to, 4), 0.01);
    const double weight = kWeight_Nm * std::sin(record.position_rad[0].back());
    EXPECT_NEAR(record.torque_Nm[0].back() / weight, share, 0.002) << to;
  }
}

// Closed form: a spring, a stop, a ripple.
TEST(RobotBenchLaws, TorquesOfAngle) {
  Laws laws;
  laws.spring_Nm_rad = 3;
  laws.spring_neutral_rad = 0.2;
  laws.upper = {40, 0.5};
  laws.ripple = {{7, 0.3, 0.1}};
  EXPECT_DOUBLE_EQ(laws.spring_and_ripple_Nm(0.6), -3 * 0.4 + 0.3 * std::sin(4.3));
  EXPECT_DOUBLE_EQ(laws.stops_Nm(0.6), -40 * (0.6 - 0.5));
  EXPECT_EQ(laws.stops_Nm(0.4), 0);
}

/// Mass matrix and bias of the joints that move, the base at rest.
void expect_same_dynamics(const mjModel& theirs, const Robot& robot, double tolerance) {
  Scene scene;
  scene.robot = robot;
  for (const Joint& joint : robot.joints)
    scene.laws[joint.name].armature_kg_m2 = joint.armature_kg_m2;
  const Model ours = compile(mjcf(scene, 1e-3));
  const Data a(mj_makeData(&theirs)), b(mj_makeData(ours.get()));
  const int base = theirs.nv - ours->nv;
  Draws draws(1);
  for (int k = 0; k < ours->nv; ++k) {
    a->qpos[theirs.nq - ours->nv + k] = b->qpos[k] = draws.uniform(-1, 1);
    a->qvel[base + k] = b->qvel[k] = draws.uniform(-3, 3);
  }
  if (base == 6) a->qpos[3] = 1;
  mj_forward(&theirs, a.get());
  mj_forward(ours.get(), b.get());
  const auto n = static_cast<std::size_t>(theirs.nv), m = static_cast<std::size_t>(ours->nv);
  std::vector<mjtNum> full(n * n), part(m * m);
  mj_fullM(&theirs, full.data(), a->qM);
  mj_fullM(ours.get(), part.data(), b->qM);
  const std::size_t off = n - m;
  for (std::size_t i = 0; i < m; ++i) {
    EXPECT_NEAR(a->qfrc_bias[off + i], b->qfrc_bias[i], tolerance);
    for (std::size_t j = 0; j < m; ++j)
      EXPECT_NEAR(full[(off + i) * n + off + j], part[i * m + j], tolerance);
  }
}

// Oracle: MuJoCo's own reading of the file. It diagonalises the full inertias that are written to
// it to some 1e-9 of them; a wrong centre or axis shows in the first three digits.
TEST(RobotBenchRobots, PublicModelsKeepTheirDynamics) {
  const auto data = data_folder();
  for (const char* name :
       {"robots/unitree_mujoco/unitree_robots/go2/go2.xml",
        "robots/unitree_mujoco/unitree_robots/g1/g1_29dof.xml", "logs/so101_arm/so101.xml",
        "robots/bullet3/data/kuka_iiwa/model.urdf"}) {
    if (!std::filesystem::exists(data / name)) GTEST_SKIP() << "no " << data / name;
    const Model model = compile_without_shapes(data / name);
    expect_same_dynamics(*model, robot_of(*model, name), 1e-7);
  }
}

// Every name has a law, and the law shows in the motion.
TEST(RobotBenchEffects, EachChangesTheMotion) {
  Scene scene = one_joint(Eigen::Vector3d::UnitY());
  scene.controllers["swing"] = {30, 1.5, kNever};
  Draws draws(2);
  const Commands commands = draw_motion(draws, scene.robot, 0.8, 0.005, 0.7);
  const Record record = play(scene, commands, 0.01);
  const auto& q = record.position_rad[0];
  const auto [low, high] = std::minmax_element(q.begin(), q.end());
  const Usage usage{1.5, 4, 1, 3, *low, *high};
  for (const std::string& name : effect_names()) {
    Scene changed = scene;
    put_on(changed.laws["swing"], name,
           parameters_of(name, 0.3, draw_flavour(draws), usage, scene.laws["swing"]));
    EXPECT_GT(differences_rad(changed, scene, commands)[0], 1e-4) << name;
  }
  EXPECT_THROW(put_on(scene.laws["swing"], "gremlins", {}), std::invalid_argument);
}

// Without public models. What "none" lacks is nothing, and a seed says all of it.
TEST(RobotBenchClasses, NoneIsAsStated) {
  const Situation none = draw_situation("none", kNoneSeed, "");
  EXPECT_EQ(differences_rad(none.truth, none.stated, sizing_piece(none))[0], 0);
  const std::string log = log_text(none, kNoneSeed);
  EXPECT_EQ(log, log_text(draw_situation("none", kNoneSeed, ""), kNoneSeed));
  EXPECT_NE(log, log_text(none, kNoneSeed + 1));
}

// What is missing shows by its size, and stands in the truth alone.
TEST(RobotBenchClasses, OneIsHiddenFromItsDocuments) {
  const Situation one = draw_situation("one", kOneSeed, "");
  EXPECT_GE(one.size_floors.at(0), kLeastFloors);
  const auto truth = truth_document(one, kOneSeed);
  EXPECT_EQ(truth.at("effects").at(0).at("effect"), one.missing.at(0).name);
  EXPECT_EQ(robot_document(one).dump().find(one.missing.at(0).name), std::string::npos);
}

TEST(RobotBenchClasses, RefusesAnUnknownClass) {
  EXPECT_THROW(draw_situation("three", 1, ""), std::invalid_argument);
}

}  // namespace
}  // namespace torquewright::oracles::robot_bench
