// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "gearbox/teeth/shifted_mesh.hpp"
#include "gearbox/train/gear_train.hpp"

namespace torquewright::gearbox {

/// A gear of a train as it is cut; diameters in its own modules.
struct CutGear {
  std::string_view name;
  bool internal = false;
  std::size_t layer = 0;
  std::int64_t teeth = 0;
  double shift = 0.0;
  double module_mm = 0.0;
  double tip_diameter = 0.0;
  double root_depth = 0.0;  ///< Below the middle line: how far its cutter reaches.

  double count() const { return static_cast<double>(teeth); }
  double root_diameter() const;
  double base_diameter() const;
  /// Diameter of the reference profile's middle line in modules: z + 2 x.
  double middle_diameter() const { return count() + 2.0 * shift; }
};

/// Two gears at the centre distance that sun and planet set; the second is a mesh's ring.
struct CutMesh {
  std::string_view name;
  std::size_t gear_1 = 0;
  std::size_t gear_2 = 0;
  /// Absent: the base circles of planet and ring do not allow this centre distance.
  std::optional<CutPair> cut;
  /// The ring's shift with which it meshes without backlash; absent as above, and of a sun's mesh.
  std::optional<double> closing_ring_shift;
};

/// All gears and meshes of a train, docs/derivations/kinematics.md "Profile shift".
struct CutTrain {
  GearTrain train;              ///< The train that it was cut from.
  std::vector<CutGear> gears;   ///< In the topology's order.
  std::vector<CutMesh> meshes;  ///< The sun's first, then those of the rings.
  double centre_mm = 0.0;
};

/// Nothing where sun and planet have no working angle.
std::optional<CutTrain> cut_train(const GearTrain& train);

/// All shifts of a train from those of sun and planets: the rings' close the centre distance; a
/// ring that no shift closes keeps its own. Nothing where sun and planet have no working angle.
std::optional<std::vector<double>> coaxial_shifts(const GearTrain& of_sun_and_planets);

}  // namespace torquewright::gearbox
