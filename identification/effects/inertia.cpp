// SPDX-License-Identifier: Apache-2.0
// Inertia of the motor's side, as the output sees it.
#include "identification/effects/families.hpp"

namespace torquewright::identification {

void add_inertia(DictionaryBuilder& builder) {
  const std::size_t column = builder.add_law("inertia", effect_with("reflected_inertia", {1.0}));
  builder.variant("reflected_inertia", {one(column, 0.0, kInfinity)});
}

}  // namespace torquewright::identification
