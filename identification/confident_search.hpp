// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/equation_fit.hpp"
#include "identification/search.hpp"

namespace torquewright::identification {

/// A selection whose every member is a confident name. What failed an acceptance test stands among
/// its rejected.
struct ConfidentSelection {
  Selection selection;
  bool has_tentative = false;  ///< Something helps, but no name for it is sure.
};

/// Searches until every member is a confident name: what fails an acceptance test is left
/// out of the next search, and what it was is said. docs/derivations/identification.md section 6.
/// Requires that the equation without any effect can be fitted. `before`: the structure of what
/// that leaves. `settled`: effects that are not asked about.
ConfidentSelection confident_search(const EquationFit& fit,
                                    const std::vector<ResidualStructure>& before,
                                    const std::vector<std::string>& settled = {});

}  // namespace torquewright::identification
