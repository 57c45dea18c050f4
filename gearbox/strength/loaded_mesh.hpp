// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gearbox/teeth/shifted_mesh.hpp"
#include "gearbox/train/gear_train.hpp"

namespace torquewright::gearbox {

/// Sun speed over output speed, signed. Requires a train that moves.
double reduction(const GearTrain& train);

/// Two gears of a train and what one planet's teeth carry between them.
struct LoadedMesh {
  std::string_view name;
  /// Names of the gears; the second is the ring of an internal mesh.
  std::array<std::string_view, 2> gears;
  /// Whether the gear is loaded on its other flank in another mesh.
  std::array<bool, 2> bends_both_ways{};
  CutPair cut;
  double contact_ratio = 0.0;
  /// Tip radius of the tool that cut each gear's root, in modules.
  std::array<double, 2> cutter_tip_radius{};
  double module_mm = 0.0;
  double face_width_mm = 0.0;
  /// Tangential force on the working pitch circles, all planets sharing alike, without losses.
  double force_per_sun_torque_N_Nm = 0.0;
  std::array<double, 2> cutter_addendum{};  ///< Depth of the cut below the middle line, in modules.
  std::int64_t shaper_teeth = 0;            ///< Teeth of a ring's shaper.
};

/// The meshes of a train with their forces, docs/derivations/strength.md eq. (1)...(3).
struct LoadedTrain {
  std::vector<LoadedMesh> meshes;
  std::vector<std::string> objections;  ///< Sentences; any: the gears do not mesh.
};
LoadedTrain loaded_train(const GearTrain& train);

/// Returns sentences on why no stress of this train means anything: gears that do not mesh, and
/// what cannot exist (constraints/existence.hpp).
std::vector<std::string> objections(const GearTrain& train);

}  // namespace torquewright::gearbox
