// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/efficiency.hpp"

namespace torquewright::gearbox {

enum class PowerFlow {
  kRuns,         ///< Power passes both ways.
  kSelfLocking,  ///< The output cannot drive the sun: backward is 0.
  kStandsStill,  ///< I2 = 1: the output ring does not move; both are 0.
  kNoMesh,       ///< A mesh efficiency lies outside (0, 1]; both are 0.
};

struct TrainEfficiency {
  PowerFlow flow = PowerFlow::kNoMesh;
  double forward = 0.0;   ///< Output power over input power, sun driving.
  double backward = 0.0;  ///< The same, output driving.
};

/// The 3K train for I2 below and above 1. docs/derivations/efficiency.md eq. (13)...(16).
[[nodiscard]] TrainEfficiency three_k_efficiency(double ratio_1, double ratio_2,
                                                 const ThreeKMeshEfficiencies<double>& mesh);

[[nodiscard]] TrainEfficiency planetary_efficiency(double ratio,
                                                   const PlanetaryMeshEfficiencies<double>& mesh);

/// Weights of the mesh losses in the forward loss, to first order: 1 - eta = sum of weight times
/// (1 - eta_mesh). docs/derivations/efficiency.md eq. (19). At I2 = 1, where they grow without
/// bound, their limiting proportions.
struct LossWeights {
  double sun_planet_1 = 0.0;
  double planet_1_fixed_ring = 0.0;
  double planet_2_output_ring = 0.0;
};
LossWeights three_k_loss_weights(double ratio_1, double ratio_2);

}  // namespace torquewright::gearbox
