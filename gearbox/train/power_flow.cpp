// SPDX-License-Identifier: Apache-2.0
#include "gearbox/train/power_flow.hpp"

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

/// What a mesh loses whose central gear passes the rolling power to the planet; a negative power
/// comes from the planet and has paid the mesh already.
double lost(double rolling_power, double efficiency) {
  return rolling_power > 0.0 ? rolling_power * (1.0 - efficiency)
                             : -rolling_power * (1.0 / efficiency - 1.0);
}

/// Powers into the train at sun and output, in units of the input power; the carrier turns at 1.
ThreeKLosses three_k_losses(double ratio_1, double ratio_2,
                            const ThreeKMeshEfficiencies<double>& mesh, double sun_power,
                            double output_power) {
  const double sun_torque = sun_power / (1.0 + ratio_1);
  const double output_torque = output_power / (1.0 - ratio_2);
  const double ring_torque = -sun_torque - output_torque;
  return {lost(sun_torque * ratio_1, mesh.sun_planet_1),
          lost(-ring_torque, mesh.planet_1_fixed_ring),
          lost(-output_torque * ratio_2, mesh.planet_2_output_ring)};
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

ThreeKLosses three_k_forward_losses(double ratio_1, double ratio_2,
                                    const ThreeKMeshEfficiencies<double>& mesh,
                                    const TrainEfficiency& efficiency) {
  if (!(efficiency.forward > 0.0)) return {};
  return three_k_losses(ratio_1, ratio_2, mesh, 1.0, -efficiency.forward);
}

ThreeKLosses three_k_backward_losses(double ratio_1, double ratio_2,
                                     const ThreeKMeshEfficiencies<double>& mesh,
                                     const TrainEfficiency& efficiency) {
  if (!(efficiency.backward > 0.0)) return {};
  return three_k_losses(ratio_1, ratio_2, mesh, -efficiency.backward, 1.0);
}

PlanetaryLosses planetary_forward_losses(double ratio,
                                         const PlanetaryMeshEfficiencies<double>& mesh,
                                         const TrainEfficiency& efficiency) {
  if (!(efficiency.forward > 0.0)) return {};
  const double from_sun = ratio / (1.0 + ratio);
  return {lost(from_sun, mesh.sun_planet), lost(from_sun * mesh.sun_planet, mesh.planet_ring)};
}

PlanetaryLosses planetary_backward_losses(double ratio,
                                          const PlanetaryMeshEfficiencies<double>& mesh,
                                          const TrainEfficiency& efficiency) {
  if (!(efficiency.backward > 0.0)) return {};
  const double to_sun = efficiency.backward * ratio / (1.0 + ratio);
  return {lost(-to_sun, mesh.sun_planet), lost(-to_sun / mesh.sun_planet, mesh.planet_ring)};
}

}  // namespace torquewright::gearbox
