// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "gearbox/strength/life_curve.hpp"

namespace torquewright::gearbox {

/// A gear steel that may be named instead of its numbers. docs/derivations/strength.md, "Steels".
struct Steel {
  std::string_view name;
  GearMaterial material;
  std::string_view source;  ///< A sentence: who states the numbers, and of what.
};

/// Only steels whose numbers a source that can be opened states.
const std::vector<Steel>& steels();

/// Null where none has the name.
const Steel* find_steel(std::string_view name);

}  // namespace torquewright::gearbox
