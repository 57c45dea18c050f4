// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "gearbox/train/cut_train.hpp"

namespace torquewright::gearbox {

/// Depth to which the hob of sun and planets is straight, by which a gear's undercut is judged:
/// that of the stated hob, else of one of 0.38, and a rack's addendum at least.
double undercut_depth(const Cutters& cutters);

/// Returns the largest tip radii of the hobs of sun and planet that leave each involute down to
/// where the mate's tip touches it, in modules. Negative: none does. Nothing where a tip reaches
/// inside a base circle.
std::optional<std::array<double, 2>> largest_hob_tip_radii(const CutTrain& train,
                                                           const CutMesh& mesh);

}  // namespace torquewright::gearbox
