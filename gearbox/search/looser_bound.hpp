// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearbox/problem.hpp"
#include "gearbox/search/search_options.hpp"
#include "gearbox/search/search_result.hpp"

namespace torquewright::gearbox {

struct ProvedBound {
  LooserBound bound;
  Claim claim;
  /// Result of the search without its trees, which are in the claim.
  optimization::SearchResult search;
};

/// Returns the bounds (JSON pointers) behind the members of a conflict, each once.
std::vector<std::string> keys_of(const Problem& problem,
                                 const std::vector<ConflictMember>& conflict);

/// Returns a bound with the value `needed` that would do, for this design. The key has to be one of
/// the problem's.
LooserBound looser_bound(const Problem& problem, const std::string& key, double needed,
                         const Design& design);

/// Returns the least change of one bound that makes the problem feasible, with its proof; nothing
/// if no value of this bound alone does.
std::optional<ProvedBound> least_change(const Problem& problem, const std::string& key,
                                        const DesignSearchOptions& options);

}  // namespace torquewright::gearbox
