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
  std::string quantity;  ///< Empty for `infeasible`.
  std::optional<Design> reference;
  std::string key;                         ///< Of `least_relaxation`.
  std::optional<std::int64_t> ring_limit;  ///< Absent: set by the rotor's bore.
  std::vector<AlternativeProof> alternatives;
};

/// One member of an irreducible set of constraints that no design satisfies together.
struct ConflictMember {
  std::string constraint;
  std::optional<Design> without_it;  ///< Satisfies all other members.
  std::string sentence;
};

/// One bound that would have to give way, alone, and how far at least.
struct LooserBound {
  std::string key;
  double limit = 0.0;   ///< As it stands.
  double needed = 0.0;  ///< Would do.
  std::string unit;
  Design design;  ///< Feasible with it.
  std::string sentence;
};

enum class DesignSearchStatus { kOptimal, kInfeasible, kLimit };

/// How many boxes the searches looked at whose trees the claims hold, so that the checker can count
/// them again.
struct SearchCounts {
  std::int64_t nodes = 0;
  std::int64_t relaxations = 0;  ///< Ipopt solves.
  std::int64_t refuted_by_relaxation = 0;
  std::int64_t points_enumerated = 0;
};

struct DesignSearchResult {
  DesignSearchStatus status = DesignSearchStatus::kLimit;
  std::vector<Design> designs;  ///< The best, in order; at most as many as asked for.
  std::vector<Design> ties;     ///< As good as the last of them, for want of room not among them.
  std::vector<double> objectives;  ///< Of `designs`, as the user reads it.
  std::optional<double> bound;     ///< Cannot be beaten; absent where nothing is known.
  std::vector<ConflictMember> conflict;
  std::vector<LooserBound> would_be_feasible_with;
  SearchCounts search;
  std::vector<Claim> claims;
};

}  // namespace torquewright::gearbox
