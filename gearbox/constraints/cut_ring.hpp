// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "gearbox/teeth/shaper.hpp"
#include "gearbox/train/cut_train.hpp"

namespace torquewright::gearbox {

/// Returns a ring's mesh as the largest roundings of its cutters need it.
PlanetInRing planet_in_ring(const CutTrain& train, const CutMesh& mesh);

/// Returns the shaper of the mesh's ring: of the stated teeth, else of as many as the planet has.
/// Nothing where no such shaper meshes with the ring.
std::optional<ShaperAtDepth> shaper_of(const CutTrain& train, const CutMesh& mesh);

}  // namespace torquewright::gearbox
