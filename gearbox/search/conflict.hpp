// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "gearbox/problem.hpp"
#include "gearbox/search/search_options.hpp"
#include "gearbox/search/search_result.hpp"

namespace torquewright::gearbox {

/// Returns a sentence about a member of a conflict: the design that exists without it, if one is
/// known.
std::string conflict_sentence(const std::string& constraint,
                              const std::optional<Design>& without_it);

/// Fills `result` of a problem that was proved to have no design: an irreducible set of constraints
/// that no design satisfies together, with its proof and with a design for every set that lacks one
/// of them; and for every single bound in it the least change that makes the problem feasible, with
/// its proof. `proofs` of `first`, the search with all constraints together, are what stands where
/// `options` end the work before a smaller set is proved.
void explain_infeasibility(const Problem& problem, const DesignSearchOptions& options,
                           std::vector<AlternativeProof> proofs,
                           const optimization::SearchResult& first, DesignSearchResult& result);

}  // namespace torquewright::gearbox
