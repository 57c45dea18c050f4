// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "gearbox/proof/claims/constraint.hpp"
#include "gearbox/proof/claims/quantity.hpp"

namespace torquewright::gearbox::proof {

/// A design that a result names: teeth complete and coaxial, planets and module of the problem.
struct Candidate {
  Point point{};
  std::int64_t planet_count = 0;
  Rational module_mm;

  friend bool operator==(const Candidate&, const Candidate&) = default;
  /// Any order, for finding them.
  friend bool operator<(const Candidate& a, const Candidate& b) {
    return std::tie(a.planet_count, a.point, a.module_mm) <
           std::tie(b.planet_count, b.point, b.module_mm);
  }
};

enum class ClaimKind { kOptimum, kInfeasible, kLeastRelaxation };

/// "No design satisfies all hypotheses and does at least as well as the reference, but those that
/// are listed" (docs/certificate.md).
struct Claim {
  ClaimKind kind = ClaimKind::kInfeasible;
  std::vector<Constraint>
      hypotheses;  ///< With `positive_teeth`; a ring limit counts as `rotor_bore`.
  std::optional<Quantity> quantity;  ///< Empty: nothing is compared.
  std::optional<Candidate> reference;
  std::optional<Value> threshold;      ///< The reference's quantity.
  std::optional<Rational> ring_limit;  ///< Teeth; where the rotor's bore is no hypothesis.
  std::set<Candidate> listed;
  bool may_be_open = false;            ///< Leaves may be left open.
  std::optional<Rational> open_bound;  ///< Holds in open leaves; empty: nothing is said of them.

  bool holds(ConstraintFamily family) const;
};

/// The problem's alternative as the claim sees it: its ring limit in place of the rotor's bore.
Alternative alternative_of(const Problem& problem, const Claim& claim, std::int64_t planet_count,
                           const Rational& module_mm);

/// All teeth that the claim speaks of, for one alternative; may be empty.
Box root_box(const Alternative& alternative);

/// Largest ring of an alternative in whole teeth; negative limits count as 0.
std::int64_t largest_ring_teeth(const Alternative& alternative);

/// A condition that can be judged on a box: a hypothesis, or the comparison with the reference.
struct Condition {
  enum class Kind { kConstraint, kRatioMax, kRatioMin, kQuantity };
  Kind kind = Kind::kQuantity;
  std::optional<Constraint> constraint;
};

/// Empty if the claim has no such condition, or it can be judged at points only.
std::optional<Condition> find_condition(const Claim& claim, std::string_view name);

}  // namespace torquewright::gearbox::proof
