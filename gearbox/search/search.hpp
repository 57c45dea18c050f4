// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/problem.hpp"
#include "gearbox/search/search_options.hpp"
#include "gearbox/search/search_result.hpp"

namespace torquewright::gearbox {

/// Finds the best gearboxes of a problem with their proof, or why there is none. Never throws for a
/// problem that read_problem accepts.
DesignSearchResult optimize(const Problem& problem, const DesignSearchOptions& options);

/// Whether the relaxations know a shape of the objective: else they close no box that intervals
/// leave open, and are not worth a solve.
bool can_be_relaxed(const Problem& problem);

}  // namespace torquewright::gearbox
