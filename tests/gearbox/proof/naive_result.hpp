// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/gearbox/proof/naive_proof.hpp"

namespace torquewright::gearbox::proof_test {

/// The D151 of the seed, planet_2 of at least 30 teeth: 44/44/32, cost 17360.11.
Problem d151();
Problem d151_infeasible();    ///< Carrier clearance of 0.30 rad, which 44/44/32 does not have.
Problem d151_tolerant();      ///< 20:1 within 2 %.
Problem planetary_8();        ///< 8:1, least mass, two planet counts and modules.
Problem most_efficient();     ///< Small 3k, forward efficiency.
Problem buildable_inertia();  ///< 3k, least inertia, all constraints that make it buildable.

/// All designs of the domain (rings up to `largest_ring` teeth; 0: the bore's) that satisfy the
/// named constraints, by trying all teeth.
std::vector<PlainDesign> find_all(const Problem& problem, const std::vector<std::string>& names,
                                  long largest_ring);

/// A whole result with its proof. `shown`: K.
Json naive_optimum(const Problem& problem, std::size_t shown, const ProofStyle& style);
/// As if the search had stopped: the first enumerated leaf is open, and `bound` a share of the
/// optimum that holds in it.
Json naive_limit(const Problem& problem, double share, const ProofStyle& style);
/// With least relaxations for the given keys.
Json naive_infeasible(const Problem& problem, const std::vector<std::string>& keys,
                      const ProofStyle& style);

/// The claims of a result, in words.
PlainClaim plain_optimum(const Problem& problem, const Json& result);
PlainClaim plain_relaxation(const Problem& problem, const Json& entry);
PlainDesign plain_design(const Json& json);

}  // namespace torquewright::gearbox::proof_test
