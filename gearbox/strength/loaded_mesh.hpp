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
  std::array<std::string_view, 2> gears;  ///< The second is the ring of an internal mesh.
  std::array<bool, 2> bends_both_ways{};  ///< Loaded on the other flank in another mesh.
  CutPair cut;
  double contact_ratio = 0.0;
  std::array<double, 2> cutter_tip_radius{};  ///< Of the tool that cut each gear's root, modules.
  double module_mm = 0.0;
  double face_width_mm = 0.0;
  /// Tangential, on the working pitch circles, all planets sharing alike, without losses.
  double force_per_sun_torque_N_Nm = 0.0;
  std::array<double, 2> cutter_addendum{};  ///< How deep it cut below the middle line, modules.
  std::int64_t shaper_teeth = 0;            ///< Of a ring's cutter.
};

/// The meshes of a train with their forces, docs/derivations/strength.md eq. (1)...(3).
struct LoadedTrain {
  std::vector<LoadedMesh> meshes;
  std::vector<std::string> objections;  ///< Sentences; any: the gears do not mesh.
};
LoadedTrain loaded_train(const GearTrain& train);

/// Why no stress of this train means anything: gears that do not mesh, and what cannot exist
/// (constraints/existence.hpp). Sentences.
std::vector<std::string> objections(const GearTrain& train);

}  // namespace torquewright::gearbox
