// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gearbox/problem.hpp"
#include "optimization/discrete/proof_tree.hpp"

namespace torquewright::gearbox {

/// The proof tree of one planet count and module, with the names its numbers stand for.
struct AlternativeProof {
  std::int64_t planet_count = 0;
  Rational module_mm;
  std::vector<std::string> variables;
  std::vector<std::string> conditions;
  optimization::ProofTree tree;
};

/// "No design satisfies all of these constraints and does at least as well as the reference, but
/// those that are listed": docs/certificate.md.
struct Claim {
  std::string kind;  ///< optimum, infeasible, least_relaxation
  std::vector<std::string> constraints;
  std::string quantity;  ///< Name of the quantity that is compared; empty for `infeasible`.
  std::optional<Design> reference;
  std::string key;                         ///< JSON pointer of the bound in a `least_relaxation`.
  std::optional<std::int64_t> ring_limit;  ///< Largest ring; absent: set by the rotor's bore.
  std::vector<AlternativeProof> alternatives;
};

/// One member of an irreducible set of constraints that no design satisfies together.
struct ConflictMember {
  std::string constraint;
  std::optional<Design> without_it;  ///< A design that satisfies all other members.
  std::string sentence;
  std::string topology = {};  ///< Of that design, where the problem leaves it open.
};

/// One bound that would have to give way, alone, and how far at least.
struct LooserBound {
  std::string key;
  double limit = 0.0;   ///< The bound as it stands.
  double needed = 0.0;  ///< A value that would do.
  std::string unit;
  Design design;  ///< A design that is feasible with it.
  std::string sentence;
};

enum class DesignSearchStatus { kOptimal, kInfeasible, kLimit };

/// Number of boxes that the searches looked at whose trees the claims hold, so that the checker can
/// count them again.
struct SearchCounts {
  std::int64_t nodes = 0;
  std::int64_t relaxations = 0;  ///< Number of Ipopt solves.
  std::int64_t refuted_by_relaxation = 0;
  std::int64_t points_enumerated = 0;
};

struct DesignSearchResult {
  DesignSearchStatus status = DesignSearchStatus::kLimit;
  std::vector<Design> designs;  ///< The best designs, in order; at most as many as asked for.
  /// Designs as good as the last of them that found no room in the list.
  std::vector<Design> ties;
  std::vector<double> objectives;  ///< Objectives of `designs`, as the user reads them.
  std::optional<double> bound;     ///< Bound that no design beats; absent where nothing is known.
  std::vector<ConflictMember> conflict;
  std::vector<LooserBound> would_be_feasible_with;
  SearchCounts search;
  std::vector<Claim> claims;
};

}  // namespace torquewright::gearbox
