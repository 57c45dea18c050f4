// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/problem.hpp"
#include "gearbox/search/search_options.hpp"
#include "gearbox/search/search_result.hpp"

namespace torquewright::gearbox {

/// The best gearboxes of a problem with their proof; or why there is none. Never throws for a
/// problem that read_problem accepts.
DesignSearchResult optimize(const Problem& problem, const DesignSearchOptions& options);

}  // namespace torquewright::gearbox
