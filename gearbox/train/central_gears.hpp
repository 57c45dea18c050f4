// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gearbox/train/efficiency.hpp"
#include "gearbox/train/power_flow.hpp"
#include "gearbox/train_parts.hpp"

namespace torquewright::gearbox {

// What follows of every train from its parts: central gears (sun, held ring, output ring or
// carrier) that roll on stepped planets. docs/derivations/kinematics.md, "Any central gears".

/// Each of its gears carrier held, z_held/p_held over z/p, p the planet that a gear rolls on.
template <class T>
struct BasicRatios {
  T first;   ///< I1, over the sun's.
  T second;  ///< I2, over the output ring's; 0 where the carrier is the output.

  /// Sun speed over output speed; requires I2 other than 1, where the output stands still.
  T reduction() const { return (T(1) + first) / (T(1) - second); }
};

template <class T>
BasicRatios<T> basic_ratios(const TrainParts& parts, std::span<const T> teeth) {
  const T held = teeth[parts.held_ring] / teeth[parts.planet_beside(parts.held_ring)];
  BasicRatios<T> ratios{held * teeth[parts.planet_beside(0)] / teeth[0], T(0)};
  if (parts.output_ring) {
    ratios.second =
        held * teeth[parts.planet_beside(*parts.output_ring)] / teeth[*parts.output_ring];
  }
  return ratios;
}

/// Speeds over the sun's, signed. Requires a train that moves.
struct TrainSpeeds {
  double carrier = 0.0;
  std::vector<double> gears;  ///< In the topology's order.
};
TrainSpeeds train_speeds(const TrainParts& parts, std::span<const double> teeth);

/// Magnitudes without losses for a torque at the sun: on each central gear, the carrier's apart,
/// by mesh. The held ring takes what sun and output leave.
std::vector<double> mesh_torques_Nm(const TrainParts& parts, std::span<const double> teeth,
                                    double sun_torque_Nm);

/// Tangential forces on one planet for 1 Nm at the sun, by mesh, on the working circles.
std::vector<double> mesh_forces_N(const TrainParts& parts, std::span<const double> teeth,
                                  std::int64_t planet_count, double centre_m);

/// Angle of the output, sun and held ring still, per length of backlash in each mesh, by mesh
/// [rad/m]; radii by gear, base radii for backlash along the line of action. Requires an output
/// that moves.
std::vector<double> mesh_backlash_rad_per_m(const TrainParts& parts, std::span<const double> teeth,
                                            std::span<const double> radii_m);

/// Efficiencies by mesh as the closed forms of a 3K train know them: of the sun, the held ring and
/// the output ring, 1 where the carrier is the output.
ThreeKMeshEfficiencies<double> by_role(const TrainParts& parts, std::span<const double> meshes);

/// The other way round.
std::vector<double> by_mesh(const TrainParts& parts, double sun, double held_ring,
                            double output_ring);

/// Whether the sun may reach under planet 2. It cannot where the second layer holds its ring beside
/// an output ring: an output that turns with the sun, I2 < 1, then needs P2 > P1.
bool may_sun_pass(const TrainParts& parts);

TrainEfficiency train_efficiency(const TrainParts& parts, std::span<const double> teeth,
                                 std::span<const double> mesh_efficiencies);

}  // namespace torquewright::gearbox
