// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/dictionary.hpp"
#include "identification/gram.hpp"

namespace torquewright::identification {

/// Orders of harmonics that are worth a column: peaks of the spectrum over angle of what a smooth
/// model leaves over in the runs that may be fitted. Whether they earn a place is for the search.
/// An order needs as much angle as one of its periods. docs/derivations/identification.md eq. (11).
Orders promising_orders(const Bench& bench, const std::vector<Signals>& signals,
                        const std::vector<std::size_t>& fold_of_run, const Extent& extent);

}  // namespace torquewright::identification
