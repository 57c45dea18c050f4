// SPDX-License-Identifier: Apache-2.0
// The generator against closed forms, and against what it states itself.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "tests/oracles/mujoco_bench/completion.hpp"
#include "tests/oracles/mujoco_bench/documents.hpp"
#include "tests/oracles/mujoco_bench/laws.hpp"
#include "tests/oracles/mujoco_bench/outside.hpp"
#include "tests/oracles/mujoco_bench/plant.hpp"

namespace torquewright::oracles::mujoco_bench {
namespace {

World pendulum() {
  World world;
  world.load = {.type = "pendulum", .inertia_kg_m2 = 0.01, .mass_kg = 2, .length_m = 0.3};
  return world;
}

// Closed form: with no torque and no friction, kinetic and potential energy add up to a constant.
// Semi-implicit Euler keeps it to the first order of step times frequency, 1e-4 * 6 rad/s.
TEST(MujocoPlant, KeepsThePendulumsEnergy) {
  const World world = pendulum();
  Plant plant(world, 0, 0, 1e-4);
  plant.set_speed(4);
  const double inertia = 0.01 + 2 * 0.09 + world.motor.armature_kg_m2();
  const double begun = inertia * 16 / 2;
  for (int k = 0; k < 30000; ++k) {
    const Motion now = plant.step({});
    const double height = 0.3 * (1 - std::cos(now.position_rad));
    const double energy =
        inertia * now.speed_rad_s * now.speed_rad_s / 2 + 2 * kGravity_m_s2 * height;
    ASSERT_NEAR(energy, begun, 2e-3 * begun);
  }
}

// Closed form: a pendulum at rest stays there while motor torque and weight differ by less than
// the dry friction, and does not creep.
TEST(MujocoPlant, DryFrictionHoldsWithoutCreep) {
  World world = pendulum();
  put_on(world, {"coulomb_friction", {{"coulomb_Nm", 0.5}}});
  Plant plant(world, 0, 0, 1e-4);
  for (int k = 0; k < 20000; ++k) plant.step({.motor_torque_Nm = 0.499});
  EXPECT_EQ(plant.motion().position_rad, 0);
  for (int k = 0; k < 2000; ++k) plant.step({.motor_torque_Nm = 0.6});
  EXPECT_GT(plant.motion().position_rad, 1e-3);
}

// Closed form, the order of losses: driving tau = eta_f/(1+k_d) (motor - drag), driven back
// |tau| = (motor + drag)/(eta_b (1-k_b)); at constant speed nothing is left for inertia.
TEST(MujocoPlant, LosesInTheMeshAndBeforeIt) {
  World world;
  world.motor.forward_efficiency = 0.9;
  world.motor.backward_efficiency = 0.8;
  put_on(world, {"coulomb_friction", {{"coulomb_Nm", 0.5}}});
  put_on(world, {"load_dependent_friction",
                 {{"driving_coefficient", 0.2}, {"backdriving_coefficient", 0.1}}});
  for (const double motor : {3.0, -3.0}) {
    Plant plant(world, 1e9, 0, 1e-4);
    plant.set_speed(2);
    const double expected = motor > 0 ? 0.9 / 1.2 * (3 - 0.5) : -(3 + 0.5) / (0.8 * 0.9);
    EXPECT_NEAR(plant.step({.motor_torque_Nm = motor}).load_torque_Nm, expected, 1e-6);
  }
}

// Closed form: within the gap the output feels nothing; held against its flank it turns with it.
TEST(MujocoPlant, TurnsFreelyWithinTheGap) {
  World world;
  world.load = {.type = "free", .inertia_kg_m2 = 0.05};
  put_on(world, {"backlash", {{"gap_rad", 0.02}}});
  Plant plant(world, 0, 0, 5e-5);
  Motion now;
  while (now.rotor_position_rad < 0.0099) now = plant.step({.motor_torque_Nm = 0.05});
  EXPECT_EQ(now.position_rad, 0);
  for (int k = 0; k < 20000; ++k) now = plant.step({.motor_torque_Nm = 0.5});
  EXPECT_NEAR(now.rotor_position_rad - now.position_rad, 0.01, 1e-5);
}

// Closed form: a torque twists the flanks by itself over the stiffness that the truth states,
// beyond half the gap, once the rotor's swing has died.
TEST(MujocoPlant, FlanksGiveAsTheTruthStates) {
  World world;
  world.load = {.type = "free", .inertia_kg_m2 = 1e9};
  put_on(world, {"backlash", {{"gap_rad", 0.02}}});
  Plant plant(world, 0, 0, 5e-5);
  Motion now;
  for (int k = 0; k < 20000; ++k) now = plant.step({.motor_torque_Nm = 0.5});
  const double twist_rad = now.rotor_position_rad - now.position_rad - 0.01;
  EXPECT_NEAR(twist_rad * flank_stiffness_Nm_rad(world), 0.5, 1e-4);
}

// Closed form of Dahl's law: towards c (1 - exp(-k x / c)) from rest, whatever the steps.
TEST(MujocoLaws, DahlIsExactInAnySteps) {
  double force = 0;
  for (int k = 0; k < 50; ++k) force = dahl_Nm(force, 2e-4, 0.4, 80);
  EXPECT_NEAR(force, 0.4 * (1 - std::exp(-80 * 0.01 / 0.4)), 1e-12);
  EXPECT_NEAR(dahl_Nm(0.1, -10, 0.4, 80), -0.4, 1e-12);
}

// Closed form: the filter passes 1 Hz and stops 60 Hz; forwards and backwards the gain at 8 Hz is
// a half, and nothing is delayed.
TEST(MujocoBalance, BandHasItsEdgeAtEightHertz) {
  for (const auto& [hz, gain] : {std::pair{1.0, 1.0}, {8.0, 0.5}, {60.0, 0.0}}) {
    std::vector<double> wave;
    for (int k = 0; k < 8000; ++k) wave.push_back(std::sin(2 * std::numbers::pi * hz * k * 1e-3));
    const auto passed = in_band(wave, 1e-3);
    for (std::size_t k = 3000; k < 5000; ++k) ASSERT_NEAR(passed[k], gain * wave[k], 2e-3);
  }
}

double rms_left(const Made& made, const std::string& equation, bool noisy) {
  const Situation& it = made.situation;
  Draws draws(5);
  double sum = 0, count = 0;
  for (const Record& record : made.records) {
    Channels channels = sense(it.bench.world, it.format, record);
    if (noisy) add_noise(channels, it.format, draws);
    const auto left = residuals(it.bench.world, it.format, record, channels).at(equation);
    for (const double x : in_band(left, it.format.row_s())) sum += x * x;
    count += static_cast<double>(left.size());
  }
  return std::sqrt(sum / count);
}

// The simulation agrees with the laws as the balance has them: with the truth, noise as stated is
// what is left (sampling of standstills and friction's steps may add a third of it).
TEST(MujocoBalance, TruthLeavesTheStatedNoise) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Made made = make_log("none", seed);
    const double noise = made.situation.noise_Nm;
    EXPECT_LT(rms_left(made, "torque_Nm", false), 0.5 * noise) << seed;
    EXPECT_NEAR(rms_left(made, "torque_Nm", true), noise, 0.15 * noise) << seed;
  }
}

// Closed form of one size: what Coulomb friction changes of a sensor's balance, while the output
// turns, is its level; in the band little of it is lost.
TEST(MujocoBalance, SizeOfCoulombFrictionIsItsLevel) {
  Draws draws(11);
  Situation it = draw_rig(draws, {.loads = {"dynamometer"}, .drive = "current"});
  it.bench.world.motor.forward_efficiency = it.bench.world.motor.backward_efficiency = 1;
  it.bench.recipes.resize(1);
  it.bench.recipes[0] = {.name = "one", .mode = Recipe::Mode::kImposed};
  it.bench.recipes[0].motion = constant(it.top_speed_rad_s);
  it.bench.recipes[0].begins_moving = true;
  World with = it.bench.world;
  put_on(with, {"coulomb_friction", {{"coulomb_Nm", 0.7}}});
  const auto levels = differences(with, it.bench.world, it.format, play(it.bench));
  EXPECT_NEAR(levels.at("torque_Nm"), 0.7, 0.002);
}

std::string all_text(const std::filesystem::path& folder) {
  std::ostringstream text;
  for (const char* name : {"log.csv", "rig.json", "actuator.json", "truth.json"})
    text << std::ifstream(folder / name).rdbuf();
  return text.str();
}

TEST(MujocoBench, SameSeedSameBytes) {
  const auto folder = std::filesystem::temp_directory_path() / "mujoco_bench_test";
  write_all(make_log("undecidable", 4), 4, folder / "a");
  write_all(make_log("undecidable", 4), 4, folder / "b");
  write_all(make_log("undecidable", 9), 9, folder / "c");
  EXPECT_EQ(all_text(folder / "a"), all_text(folder / "b"));
  EXPECT_NE(all_text(folder / "a"), all_text(folder / "c"));
  std::filesystem::remove_all(folder);
}

// What is missing must not be stated, and what is stated is in the truth as well.
TEST(MujocoBench, DocumentsHideWhatIsMissing) {
  const Made made = make_log("one", 2);
  const std::string stated = actuator_document(made.situation).dump();
  EXPECT_EQ(stated.find(made.situation.missing[0].name), std::string::npos);
  const auto truth = truth_document(made.situation, 2);
  EXPECT_EQ(truth.at("effects").at(0).at("effect"), made.situation.missing[0].name);
  EXPECT_EQ(truth.at("accept").at(0).at(0), made.situation.missing[0].name);
}

// Every effect and every kind of outside has a law that takes the parameters drawn for it.
TEST(MujocoBench, EveryNameHasALaw) {
  Draws draws(3);
  const Situation it = draw_rig(draws, {});
  World world;
  for (const std::string& name : effect_names())
    EXPECT_NO_THROW(put_on(world, make_effect(name, 0.5, it, draws))) << name;
  for (const Outside& kind : outside_kinds()) {
    EXPECT_EQ(kind.make(0.5, it, draws).name, kind.kind);
    EXPECT_NO_THROW(put_on(world, kind.make(0.5, it, draws))) << kind.kind;
  }
  EXPECT_GE(outside_kinds().size(), 12U);
  EXPECT_THROW(put_on(world, {"gremlins", {}}), std::invalid_argument);
}

TEST(MujocoBench, RefusesAnUnknownClass) {
  EXPECT_THROW(make_log("three", 1), std::invalid_argument);
}

}  // namespace
}  // namespace torquewright::oracles::mujoco_bench
