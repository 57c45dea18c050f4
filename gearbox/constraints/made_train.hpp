// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "gearbox/problem.hpp"
#include "gearbox/teeth/shaper.hpp"
#include "gearbox/train/gear_train.hpp"

namespace torquewright::gearbox {

/// A gear of the train; lengths in modules.
struct MadeGear {
  std::string_view name;
  std::int64_t teeth = 0;
  double shift = 0.0;
  double tip_diameter = 0.0;

  double count() const { return static_cast<double>(teeth); }
};

struct MadeLayer {
  std::string_view name;
  std::string_view ring_mesh;
  MadeGear planet;
  MadeGear ring;
};

/// What the conditions below need of a train whose sun and planet 1 mesh.
struct MadeTrain {
  MadeGear sun;
  std::vector<MadeLayer> layers;
  std::int64_t planet_count = 0;
  Rational module_mm;
  double centre = 0.0;  ///< In modules.
  bool is_shifted = false;
};

/// Nothing where the shifts of sun and planet 1 leave no working angle.
std::optional<MadeTrain> made(const GearTrain& train);

PlanetInRing planet_in_ring(const MadeTrain& train, const MadeLayer& layer);

/// Of the stated teeth, else of as many as the planet has.
std::optional<ShaperAtDepth> shaper_of(const MadeLayer& layer, const Cutters& cutters);

}  // namespace torquewright::gearbox
