// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "gearbox/teeth/tooth_geometry.hpp"
#include "gearbox/train/assembly_phase.hpp"
#include "tests/gearbox/teeth/mesh_oracle.hpp"

namespace torquewright::gearbox {
namespace {

constexpr double kTolerance = 1e-6;          // Modules; the limit of the requirement.
constexpr double kPitch = std::numbers::pi;  // Modules.

struct Mesh {
  std::string name;
  PlacedGear gear;
  PlacedGear mate;
};

Point at(double radius, double angle_rad) {
  return {radius * std::cos(angle_rad), radius * std::sin(angle_rad)};
}

double center_distance(std::int64_t sun, std::int64_t planet) {
  return 0.5 * static_cast<double>(sun + planet);
}

std::vector<Mesh> meshes_3k(const CompoundTeeth& teeth, const AssemblyPhase& phase) {
  const double a = center_distance(teeth.sun, teeth.planet_1);
  const PlacedGear sun{external_gear(teeth.sun), {}, phase.sun_rad};
  const PlacedGear fixed{internal_gear(teeth.fixed_ring), {}, phase.fixed_ring_rad};
  const PlacedGear output{internal_gear(teeth.output_ring), {}, phase.output_ring_rad};
  const ToothForm form_1 = external_gear_in_ring(teeth.planet_1, 0.0, fixed.form, a);
  const ToothForm form_2 = external_gear_in_ring(teeth.planet_2, 0.0, output.form, a);
  std::vector<Mesh> meshes;
  for (const PlanetPhase& planet : phase.planets) {
    const PlacedGear planet_1{form_1, at(a, planet.position_rad), planet.planet_1_rad};
    const PlacedGear planet_2{form_2, at(a, planet.position_rad), planet.planet_2_rad};
    meshes.push_back({"sun", planet_1, sun});
    meshes.push_back({"fixed ring", planet_1, fixed});
    meshes.push_back({"output ring", planet_2, output});
  }
  return meshes;
}

std::vector<Mesh> meshes_planetary(std::int64_t sun_teeth, std::int64_t planet_teeth,
                                   std::int64_t ring_teeth, std::int64_t planet_count) {
  const AssemblyPhase phase = assemble_planetary(sun_teeth, planet_teeth, ring_teeth, planet_count);
  const double a = center_distance(sun_teeth, planet_teeth);
  const PlacedGear sun{external_gear(sun_teeth), {}, phase.sun_rad};
  const PlacedGear ring{internal_gear(ring_teeth), {}, phase.fixed_ring_rad};
  const ToothForm form = external_gear_in_ring(planet_teeth, 0.0, ring.form, a);
  std::vector<Mesh> meshes;
  for (const PlanetPhase& planet : phase.planets) {
    const PlacedGear placed{form, at(a, planet.position_rad), planet.planet_1_rad};
    meshes.push_back({"sun", placed, sun});
    meshes.push_back({"ring", placed, ring});
  }
  return meshes;
}

std::vector<Mesh> meshes_compound(std::int64_t sun_teeth, std::int64_t planet_1_teeth,
                                  std::int64_t planet_2_teeth, std::int64_t planet_count) {
  const std::int64_t ring_teeth = sun_teeth + planet_1_teeth + planet_2_teeth;
  const AssemblyPhase phase =
      assemble_compound(sun_teeth, planet_1_teeth, planet_2_teeth, ring_teeth, planet_count);
  const double a = center_distance(sun_teeth, planet_1_teeth);
  const PlacedGear sun{external_gear(sun_teeth), {}, phase.sun_rad};
  const PlacedGear ring{internal_gear(ring_teeth), {}, phase.output_ring_rad};
  const ToothForm form_2 = external_gear_in_ring(planet_2_teeth, 0.0, ring.form, a);
  std::vector<Mesh> meshes;
  for (const PlanetPhase& planet : phase.planets) {
    const Point place = at(a, planet.position_rad);
    meshes.push_back({"sun", {external_gear(planet_1_teeth), place, planet.planet_1_rad}, sun});
    meshes.push_back({"ring", {form_2, place, planet.planet_2_rad}, ring});
  }
  return meshes;
}

void expect_mesh(const Mesh& mesh) {
  const Contact contact = measure_contact(mesh.gear, mesh.mate);
  EXPECT_LE(contact.deepest(), kTolerance) << mesh.name;
  EXPECT_GE(contact.loosest(), -kTolerance) << mesh.name;
}

void expect_all_mesh(const CompoundTeeth& teeth, std::int64_t planet_count) {
  SCOPED_TRACE(testing::Message() << teeth.sun << "/" << teeth.planet_1 << "/" << teeth.planet_2
                                  << "/" << teeth.fixed_ring << "/" << teeth.output_ring
                                  << " n=" << planet_count);
  for (const Mesh& mesh : meshes_3k(teeth, assemble_3k(teeth, planet_count))) expect_mesh(mesh);
}

CompoundTeeth coaxial(std::int64_t sun, std::int64_t planet_1, std::int64_t planet_2) {
  return {sun, planet_1, planet_2, sun + 2 * planet_1, sun + planet_1 + planet_2};
}

// Zero-shift limit of involute interference between a planet and a ring (the closed form of
// docs/gearbox_constraints.md solved for the ring), with one tooth to spare.
bool ring_is_free(std::int64_t planet, std::int64_t ring) {
  const double sine = std::sin(20.0 * std::numbers::pi / 180.0);
  const double z = static_cast<double>(planet);
  const double denominator = 2.0 * z * sine * sine - 4.0;
  return denominator > 0.0 && ring - planet >= 10 &&
         static_cast<double>(ring - 1) >= (z * z * sine * sine - 4.0) / denominator;
}

TEST(AssembledMesh, D151TouchesOnBothFlanksEverywhere) {
  expect_all_mesh({44, 44, 32, 132, 120}, 4);
}

TEST(AssembledMesh, UndercutSunOfTwelveTeethMeshes) { expect_all_mesh(coaxial(12, 39, 32), 3); }

TEST(AssembledMesh, DifferentPlanetsMeshWithTheirOwnClocking) {
  expect_all_mesh({44, 42, 31, 128, 117}, 4);
  expect_all_mesh(coaxial(45, 43, 32), 4);  // All four planets differ in place: 176/4.
}

TEST(AssembledMesh, UnequallySpacedPlanetsMesh) {
  const CompoundTeeth teeth = coaxial(43, 44, 32);  // 174 places for 4 planets.
  EXPECT_FALSE(assemble_3k(teeth, 4).equally_spaced);
  expect_all_mesh(teeth, 4);
}

TEST(AssembledMesh, LargerSecondPlanetMeshes) { expect_all_mesh(coaxial(36, 34, 41), 5); }

TEST(AssembledMesh, PlanetaryMeshes) {
  for (const Mesh& mesh : meshes_planetary(45, 30, 105, 3)) expect_mesh(mesh);
  for (const Mesh& mesh : meshes_planetary(25, 65, 155, 3)) expect_mesh(mesh);
  for (const Mesh& mesh : meshes_planetary(24, 33, 90, 5)) expect_mesh(mesh);
}

// Planets alike, of two part numbers, and each another; both parities of planet 1.
TEST(AssembledMesh, CompoundMeshes) {
  for (const Mesh& mesh : meshes_compound(24, 44, 22, 4)) expect_mesh(mesh);
  for (const Mesh& mesh : meshes_compound(21, 45, 26, 4)) expect_mesh(mesh);
  for (const Mesh& mesh : meshes_compound(25, 43, 30, 5)) expect_mesh(mesh);
  for (const Mesh& mesh : meshes_compound(24, 30, 36, 3)) expect_mesh(mesh);
}

TEST(AssembledMesh, RandomDesignsMesh) {
  std::mt19937 generator(20);
  std::uniform_int_distribution<std::int64_t> sun(12, 70), planet(24, 60), count(3, 6);
  int meshed = 0;
  while (meshed < 30) {
    const CompoundTeeth teeth = coaxial(sun(generator), planet(generator), planet(generator));
    const std::int64_t n = count(generator);
    if (!ring_is_free(teeth.planet_1, teeth.fixed_ring)) continue;
    if (!ring_is_free(teeth.planet_2, teeth.output_ring)) continue;
    expect_all_mesh(teeth, n);
    ++meshed;
  }
}

// Oracle: the published shifted set (12/39/90 teeth, x = 0.476/0.762/2.000), whose working pressure
// angle and centre distance follow from inv(w) = inv(alpha) + 2 tan(alpha) (x1 + x2)/(z1 + z2).
TEST(AssembledMesh, ShiftedGearsMesh) {
  const double target = involute(kPressureAngle_rad) +
                        2.0 * std::tan(kPressureAngle_rad) * (0.476 + 0.762) / (12.0 + 39.0);
  double working_rad = kPressureAngle_rad;
  for (int step = 0; step < 30; ++step) {
    working_rad -= (involute(working_rad) - target) / std::pow(std::tan(working_rad), 2);
  }
  const double a = 25.5 * std::cos(kPressureAngle_rad) / std::cos(working_rad);
  ToothForm sun = external_gear(12, 0.476);
  sun.tip_radius = 6.0 + 1.0 + (a - 25.5) - 0.762;  // Equal tip clearance.
  const ToothForm ring = internal_gear(90, 2.0);
  ToothForm planet = external_gear_in_ring(39, 0.762, ring, a);
  planet.tip_radius = 19.5 + 1.0 + (a - 25.5) - 0.476;
  const AssemblyPhase phase = assemble_planetary(12, 39, 90, 3);
  for (const PlanetPhase& position : phase.planets) {
    const PlacedGear placed{planet, at(a, position.position_rad), position.planet_1_rad};
    expect_mesh({"sun", placed, {sun, {}, phase.sun_rad}});
    expect_mesh({"ring", placed, {ring, {}, phase.fixed_ring_rad}});
  }
}

// Conjugate action: turned by their tooth ratio with the carrier at rest, two gears stay in touch
// on both flanks.
TEST(AssembledMesh, StaysInTouchWhileItTurns) {
  const CompoundTeeth teeth{44, 44, 32, 132, 120};
  constexpr int kSteps = 25;
  std::vector<Mesh> meshes = meshes_3k(teeth, assemble_3k(teeth, 4));
  meshes.resize(3);  // Those of the first planet.
  for (const Mesh& mesh : meshes) {
    for (int step = 0; step < kSteps; ++step) {
      Mesh turning = mesh;
      const double gear_teeth = static_cast<double>(mesh.gear.form.teeth);
      const double mate_teeth = static_cast<double>(mesh.mate.form.teeth);
      const double turn_rad = 2.0 * std::numbers::pi * step / (kSteps * gear_teeth);
      const double direction = mesh.mate.form.internal ? 1.0 : -1.0;
      turning.gear.phase_rad += turn_rad;
      turning.mate.phase_rad += direction * turn_rad * gear_teeth / mate_teeth;
      expect_mesh(turning);
    }
  }
}

// Positive control: a hundredth of a pitch off, the flanks overlap by its normal component.
TEST(MeshOracle, SeesAPhaseAHundredthOfAPitchOff) {
  const CompoundTeeth teeth{44, 44, 32, 132, 120};
  const double expected = 0.01 * kPitch * std::cos(kPressureAngle_rad);
  for (Mesh mesh : meshes_3k(teeth, assemble_3k(teeth, 4))) {
    mesh.gear.phase_rad += 0.01 * kPitch / (0.5 * static_cast<double>(mesh.gear.form.teeth));
    const Contact contact = measure_contact(mesh.gear, mesh.mate);
    EXPECT_NEAR(contact.deepest(), expected, 1e-6) << mesh.name;
    EXPECT_NEAR(contact.loosest(), -expected, 1e-6) << mesh.name;
  }
}

// Positive control: the other clocking of a set that needs two kinds of planets does not fit.
TEST(MeshOracle, SeesAPlanetOfTheWrongPartNumber) {
  const CompoundTeeth teeth{44, 42, 31, 128, 117};
  AssemblyPhase phase = assemble_3k(teeth, 4);
  ASSERT_EQ(phase.planet_types, 2);
  phase.planets[1].planet_2_rad = phase.planets[1].planet_1_rad + phase.planets[0].clocking_rad;
  EXPECT_GT(
      measure_contact(meshes_3k(teeth, phase)[5].gear, meshes_3k(teeth, phase)[5].mate).deepest(),
      1e-3);
}

double ring_penetration(std::int64_t planet, std::int64_t ring) {
  const double a = 0.5 * static_cast<double>(ring - planet);
  const ToothForm ring_form = internal_gear(ring);
  return measure_contact({external_gear_in_ring(planet, 0.0, ring_form, a), {a, 0.0}, 0.0},
                         {ring_form, {}, 0.0})
      .deepest();
}

// The limits of docs/gearbox_constraints.md, seen from both sides by the drawn outlines.
TEST(MeshOracle, SeesInternalInterference) {
  EXPECT_GT(ring_penetration(20, 48), 1e-3);  // Involute: needs 64.
  EXPECT_GT(ring_penetration(20, 60), kTolerance);
  EXPECT_LE(ring_penetration(20, 66), kTolerance);
  EXPECT_GT(ring_penetration(30, 36), 1e-3);  // Trochoid: tips collide, needs about 39.
  EXPECT_LE(ring_penetration(30, 40), kTolerance);
}

}  // namespace
}  // namespace torquewright::gearbox
