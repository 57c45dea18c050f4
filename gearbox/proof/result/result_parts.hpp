// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "gearbox/proof/claims/candidate.hpp"
#include "gearbox/proof/claims/relaxed_bound.hpp"
#include "gearbox/proof/tree/tree.hpp"

namespace torquewright::gearbox::proof {

/// Numbers of a result may be off by this much, relatively: a few roundings of a double.
bool is_written_as(const Json* json, const Value& value);

/// What `designs` and `ties` list, checked one by one and in their order.
struct ListedDesigns {
  std::vector<Candidate> designs;
  std::vector<Candidate> ties;

  std::vector<Candidate> all() const;
};
ListedDesigns check_designs(const Problem& problem, const Json& result, Account& account);

/// The design's objective.
Value objective_of(const Problem& problem, const Candidate& candidate);

/// `objective`, `bound` and `gap` of a result that is optimal or ended at a limit.
void check_bounds(const Problem& problem, const Json& result, const ListedDesigns& listed,
                  bool is_optimal, Faults& faults);

/// What a claim has to say, for comparison with what it says.
struct DemandedClaim {
  ClaimKind kind = ClaimKind::kOptimum;
  std::vector<Constraint> hypotheses;
  std::string quantity_name;  ///< Empty: null.
  std::optional<Quantity> quantity;
  std::string key;  ///< Empty: none.
  std::optional<Candidate> reference;
  bool reference_is_open = false;  ///< Or null, if all designs are listed.
  std::vector<Candidate> listed;
  bool may_be_open = false;
  std::optional<Rational> open_bound;
};

/// Checks head and trees of one claim. Says whether a tree has open leaves through the counts.
void check_claim(const Problem& problem, const DemandedClaim& demanded, const Json& json,
                 const std::string& place, Account& account);

/// The constraints of `conflict` and their witnesses. Empty after a fault in the names.
std::vector<Constraint> check_conflict(const Problem& problem, const Json& result, Faults& faults);

/// The least relaxation that each entry of `would_be_feasible_with` has to prove, in order.
std::vector<DemandedClaim> check_relaxations(const Problem& problem, const Json& result,
                                             Faults& faults);

}  // namespace torquewright::gearbox::proof
