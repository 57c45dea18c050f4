// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/mesh_stiffness.hpp"

#include <cstddef>

#include "gearbox/teeth/tooth_geometry.hpp"
#include "gearbox/train/central_gears.hpp"

namespace torquewright::gearbox {
namespace {

/// Base radii in the topology's order.
std::vector<double> base_radii_mm(const GearTrain& train) {
  const TrainParts& parts = train_parts(train.topology);
  std::vector<double> radii_mm;
  for (std::size_t gear = 0; gear < train.teeth.size(); ++gear) {
    radii_mm.push_back(0.5 * kReferenceCosine * static_cast<double>(train.teeth[gear]) *
                       train.module_of_layer_mm(parts.gear_layers[gear]));
  }
  return radii_mm;
}

/// Two springs in a row of half the softness each: one for every gear's steel.
double modulus_share(const StrengthCase& strength, const LoadedMesh& mesh) {
  const double first = strength.material_of(mesh.gears[0]).young_MPa;
  const double second = strength.material_of(mesh.gears[1]).young_MPa;
  return 2.0 * first * second / (first + second) / kStiffnessYoung_MPa;
}

}  // namespace

std::vector<double> layer_softness_rad_mm_Nm(const StrengthCase& strength) {
  const GearTrain& train = strength.train;
  const TrainParts& parts = train_parts(train.topology);
  const std::vector<double> teeth(train.teeth.begin(), train.teeth.end());
  const auto turns_rad_mm = mesh_backlash_rad_per_m(parts, teeth, base_radii_mm(train));
  const std::vector<LoadedMesh> meshes = loaded_train(train).meshes;
  std::vector<double> softness(parts.layer_count(), 0.0);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const double pair = mesh_stiffness_N_mm_um(meshes[i].contact_ratio);
    softness[parts.gear_layers[parts.meshes[i].gear_2]] +=
        turns_rad_mm[i] * turns_rad_mm[i] /
        (static_cast<double>(train.planet_count) * pair * modulus_share(strength, meshes[i]));
  }
  return softness;
}

double torsional_stiffness_Nm_rad(const StrengthCase& strength) {
  const std::vector<double> softness = layer_softness_rad_mm_Nm(strength);
  double sum_rad_Nm = 0.0;
  for (std::size_t layer = 0; layer < softness.size(); ++layer) {
    sum_rad_Nm += softness[layer] / strength.train.face_width_mm[layer];
  }
  return 1.0 / sum_rad_Nm;
}

}  // namespace torquewright::gearbox
