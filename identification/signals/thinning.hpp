// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/signals/signals.hpp"

namespace torquewright::identification {

/// Keeps every `factor`-th sample, from the first, of all signals but the voltage's fast part; the
/// step grows by that factor. A factor of 1 changes nothing.
void thin(Signals& signals, std::size_t factor);

}  // namespace torquewright::identification
