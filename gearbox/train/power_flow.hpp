// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/train/efficiency.hpp"

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

/// What every mesh loses, as a share of the power that goes into the train: the sum is 1 minus the
/// efficiency, exactly. docs/derivations/efficiency.md eq. (20).
struct ThreeKLosses {
  double sun_planet_1 = 0.0;
  double planet_1_fixed_ring = 0.0;
  double planet_2_output_ring = 0.0;
};
/// The efficiency is that of the same ratios and meshes; all are 0 where nothing turns.
ThreeKLosses three_k_forward_losses(double ratio_1, double ratio_2,
                                    const ThreeKMeshEfficiencies<double>& mesh,
                                    const TrainEfficiency& efficiency);
ThreeKLosses three_k_backward_losses(double ratio_1, double ratio_2,
                                     const ThreeKMeshEfficiencies<double>& mesh,
                                     const TrainEfficiency& efficiency);

struct PlanetaryLosses {
  double sun_planet = 0.0;
  double planet_ring = 0.0;
};
PlanetaryLosses planetary_forward_losses(double ratio,
                                         const PlanetaryMeshEfficiencies<double>& mesh,
                                         const TrainEfficiency& efficiency);
PlanetaryLosses planetary_backward_losses(double ratio,
                                          const PlanetaryMeshEfficiencies<double>& mesh,
                                          const TrainEfficiency& efficiency);

}  // namespace torquewright::gearbox
