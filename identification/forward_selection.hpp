// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/trials.hpp"

namespace torquewright::identification {

/// The best model that a search finds, from nothing and from the best pair of effects.
/// docs/derivations/identification.md section 4. Requires that the empty model is valid.
Fit best_model(const Trials& trials);

}  // namespace torquewright::identification
