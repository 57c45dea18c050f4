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
  std::string_view source;  ///< A sentence: who states the numbers, and for which steel.
};

/// Returns the steels. Only those whose numbers are stated by a source that can be opened.
const std::vector<Steel>& steels();

/// Finds a steel; null where none has the name.
const Steel* find_steel(std::string_view name);

}  // namespace torquewright::gearbox
