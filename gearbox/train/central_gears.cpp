// SPDX-License-Identifier: Apache-2.0
#include "gearbox/train/central_gears.hpp"

#include <cmath>

namespace torquewright::gearbox {
namespace {

bool is_held(const TrainParts& parts, const MeshedGears& mesh) {
  return mesh.gear_2 == parts.held_ring;
}

/// The sun's own mesh comes first; in the others the ring is the central gear.
std::size_t central_gear(const TrainParts& parts, const MeshedGears& mesh) {
  return parts.is_ring(mesh.gear_2) ? mesh.gear_2 : mesh.gear_1;
}

double working_radius_m(const TrainParts& parts, std::span<const double> teeth, std::size_t central,
                        double centre_m) {
  const double planet = teeth[parts.planet_beside(central)];
  const double between = parts.is_ring(central) ? teeth[central] - planet : teeth[central] + planet;
  return centre_m * teeth[central] / between;
}

}  // namespace

TrainSpeeds train_speeds(const TrainParts& parts, std::span<const double> teeth) {
  const BasicRatios<double> ratios = basic_ratios(parts, teeth);
  TrainSpeeds speeds;
  speeds.carrier = 1.0 / (1.0 + ratios.first);
  const double held = teeth[parts.held_ring] / teeth[parts.planet_beside(parts.held_ring)];
  for (std::size_t gear = 0; gear < parts.gears.size(); ++gear) {
    if (parts.is_planet(gear)) {
      speeds.gears.push_back((1.0 - held) * speeds.carrier);
    } else if (parts.is_ring(gear)) {
      speeds.gears.push_back(gear == parts.held_ring ? 0.0 : 1.0 / ratios.reduction());
    } else {
      speeds.gears.push_back(1.0);
    }
  }
  return speeds;
}

std::vector<double> mesh_torques_Nm(const TrainParts& parts, std::span<const double> teeth,
                                    double sun_torque_Nm) {
  const double reduction = basic_ratios(parts, teeth).reduction();
  std::vector<double> torques_Nm;
  for (const MeshedGears& mesh : parts.meshes) {
    const double per_sun = !parts.is_ring(mesh.gear_2) ? 1.0
                           : is_held(parts, mesh)      ? reduction - 1.0
                                                       : reduction;
    torques_Nm.push_back(std::abs(per_sun * sun_torque_Nm));
  }
  return torques_Nm;
}

std::vector<double> mesh_forces_N(const TrainParts& parts, std::span<const double> teeth,
                                  std::int64_t planet_count, double centre_m) {
  std::vector<double> forces_N = mesh_torques_Nm(parts, teeth, 1.0);
  for (std::size_t i = 0; i < forces_N.size(); ++i) {
    const std::size_t central = central_gear(parts, parts.meshes[i]);
    forces_N[i] /=
        static_cast<double>(planet_count) * working_radius_m(parts, teeth, central, centre_m);
  }
  return forces_N;
}

std::vector<double> mesh_backlash_rad_per_m(const TrainParts& parts, std::span<const double> teeth,
                                            std::span<const double> radii_m) {
  // By reciprocity: a gap in a mesh gives the output what a torque there gives the mesh.
  const double sun_Nm = 1.0 / basic_ratios(parts, teeth).reduction();
  std::vector<double> angles = mesh_torques_Nm(parts, teeth, sun_Nm);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    angles[i] /= radii_m[central_gear(parts, parts.meshes[i])];
  }
  return angles;
}

ThreeKMeshEfficiencies<double> by_role(const TrainParts& parts, std::span<const double> meshes) {
  ThreeKMeshEfficiencies<double> roles{meshes.front(), 1.0, 1.0};
  for (std::size_t i = 1; i < meshes.size(); ++i) {
    (is_held(parts, parts.meshes[i]) ? roles.planet_1_fixed_ring : roles.planet_2_output_ring) =
        meshes[i];
  }
  return roles;
}

std::vector<double> by_mesh(const TrainParts& parts, double sun, double held_ring,
                            double output_ring) {
  std::vector<double> meshes{sun};
  for (std::size_t i = 1; i < parts.meshes.size(); ++i) {
    meshes.push_back(is_held(parts, parts.meshes[i]) ? held_ring : output_ring);
  }
  return meshes;
}

bool may_sun_pass(const TrainParts& parts) {
  if (parts.layer_count() < 2) return false;
  return !parts.output_ring || parts.gear_layers[parts.held_ring] == 0;
}

TrainEfficiency train_efficiency(const TrainParts& parts, std::span<const double> teeth,
                                 std::span<const double> mesh_efficiencies) {
  const auto [first, second] = basic_ratios(parts, teeth);
  return three_k_efficiency(first, second, by_role(parts, mesh_efficiencies));
}

}  // namespace torquewright::gearbox
