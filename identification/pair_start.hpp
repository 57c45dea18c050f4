// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/trials.hpp"

namespace torquewright::identification {

/// The best sound pair of two effects, of the few best variants of each: what only two together
/// explain is found so. Not valid if no pair is acceptable.
Fit best_pair(const Trials& trials);

}  // namespace torquewright::identification
