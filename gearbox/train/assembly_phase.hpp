// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace torquewright::gearbox {

/// Where one planet stands. Phase: the direction of the middle of one tooth, counter-clockwise from
/// the x axis of the gearbox; planet 1 of every planet is alike, so that clocking names the part.
struct PlanetPhase {
  double position_rad = 0.0;
  double planet_1_rad = 0.0;
  double planet_2_rad = 0.0;     ///< Of stepped planets only.
  double clocking_rad = 0.0;     ///< planet_2_rad - planet_1_rad, in (-2 pi g/(P1 P2), 0].
  std::int64_t part_number = 1;  ///< Planets of one number are alike; from 1, in order of position.
};

/// How a gear train stands when it is assembled, the first planet on the x axis.
/// Phase of a ring: the direction of the middle of one tooth space.
struct AssemblyPhase {
  double sun_rad = 0.0;
  double fixed_ring_rad = 0.0;   ///< Of the ring in the sun's layer.
  double output_ring_rad = 0.0;  ///< Of the ring in the other layer.
  std::vector<PlanetPhase> planets;
  bool equally_spaced = true;     ///< False: each planet stands at the nearest place that meshes.
  std::int64_t planet_types = 1;  ///< Different part numbers.
};

/// Teeth of the five gears of a 3K train, all positive.
struct CompoundTeeth {
  std::int64_t sun = 0;
  std::int64_t planet_1 = 0;
  std::int64_t planet_2 = 0;
  std::int64_t fixed_ring = 0;
  std::int64_t output_ring = 0;
};

/// Phases with which every mesh of a 3K train has tooth against space on its line of centres
/// (docs/derivations/assembly_phase.md). Throws std::invalid_argument unless all are positive.
AssemblyPhase assemble_3k(const CompoundTeeth& teeth, std::int64_t planet_count);

/// The same for a sun on planet 1 and one ring, on planet 2: planets stand at equal angles whatever
/// the teeth. Throws std::invalid_argument unless all are positive.
AssemblyPhase assemble_compound(std::int64_t sun, std::int64_t planet_1, std::int64_t planet_2,
                                std::int64_t ring, std::int64_t planet_count);

/// The same for a sun, planets and one ring. Throws std::invalid_argument unless all are positive.
AssemblyPhase assemble_planetary(std::int64_t sun, std::int64_t planet, std::int64_t ring,
                                 std::int64_t planet_count);

}  // namespace torquewright::gearbox
