// SPDX-License-Identifier: Apache-2.0
#include "gearbox/power_flow.hpp"

#include <cmath>

namespace torquewright::gearbox {

namespace {

bool is_mesh_efficiency(double value) { return value > 0.0 && value <= 1.0; }

TrainEfficiency judged(double forward, double backward) {
  if (backward > 0.0) return {PowerFlow::kRuns, forward, backward};
  return {PowerFlow::kSelfLocking, forward, 0.0};
}

/// I2 > 1: the output ring turns against the sun. docs/derivations/efficiency.md eq. (15), (16).
TrainEfficiency reversed(double ratio_1, double ratio_2,
                         const ThreeKMeshEfficiencies<double>& mesh) {
  const double a = mesh.sun_planet_1;
  const double b = mesh.planet_1_fixed_ring;
  const double c = mesh.planet_2_output_ring;
  const double forward =
      c * (b + a * ratio_1) * (ratio_2 - 1.0) / ((1.0 + ratio_1) * (ratio_2 - b * c));
  const double backward =
      a * (1.0 + ratio_1) * (b * c * ratio_2 - 1.0) / ((a + b * ratio_1) * (ratio_2 - 1.0));
  return judged(forward, backward);
}

}  // namespace

TrainEfficiency three_k_efficiency(double ratio_1, double ratio_2,
                                   const ThreeKMeshEfficiencies<double>& mesh) {
  if (!is_mesh_efficiency(mesh.sun_planet_1) || !is_mesh_efficiency(mesh.planet_1_fixed_ring) ||
      !is_mesh_efficiency(mesh.planet_2_output_ring)) {
    return {PowerFlow::kNoMesh, 0.0, 0.0};
  }
  if (ratio_2 == 1.0) return {PowerFlow::kStandsStill, 0.0, 0.0};
  if (ratio_2 > 1.0) return reversed(ratio_1, ratio_2, mesh);
  return judged(three_k_forward_efficiency(ratio_1, ratio_2, mesh),
                three_k_backward_efficiency(ratio_1, ratio_2, mesh));
}

TrainEfficiency planetary_efficiency(double ratio, const PlanetaryMeshEfficiencies<double>& mesh) {
  if (!is_mesh_efficiency(mesh.sun_planet) || !is_mesh_efficiency(mesh.planet_ring)) {
    return {PowerFlow::kNoMesh, 0.0, 0.0};
  }
  return {PowerFlow::kRuns, planetary_forward_efficiency(ratio, mesh),
          planetary_backward_efficiency(ratio, mesh)};
}

LossWeights three_k_loss_weights(double ratio_1, double ratio_2) {
  const double sun = ratio_1 / (1.0 + ratio_1);
  if (ratio_2 == 1.0) return {0.0, 1.0, 1.0};
  if (ratio_2 < 1.0) {
    const double rings = ratio_2 / (1.0 - ratio_2);
    return {sun, sun + rings, rings};
  }
  return {sun, 1.0 / (1.0 + ratio_1) + 1.0 / (ratio_2 - 1.0), ratio_2 / (ratio_2 - 1.0)};
}

}  // namespace torquewright::gearbox
