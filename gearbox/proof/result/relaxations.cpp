// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gearbox/proof/result/result_parts.hpp"

namespace torquewright::gearbox::proof {
namespace {

std::vector<Constraint> without_key(const Problem& problem, const std::string& key) {
  std::vector<Constraint> others;
  for (const Constraint& each : constraints_of(problem)) {
    if (each.key != key) others.push_back(each);
  }
  return others;
}

/// `needed` admits the design, and no better one by more than rounding.
void check_needed(const Problem& problem, const RelaxedBound& bound, const Candidate& design,
                  const Json* json, const std::string& place, Faults& faults) {
  const auto needed = decimal(json);
  const auto relaxed = needed ? with_bound(problem, bound, *needed) : std::nullopt;
  if (!relaxed) {
    faults.add(place, "is no value for this bound");
    return;
  }
  check_feasibility(*relaxed, constraints_of(*relaxed), design, place, faults);
  const Alternative alternative(problem, design.planet_count, design.module_mm);
  const Value quantity = value_at(bound.quantity, alternative, design.point);
  const Interval margin = sign(quantity.enclosure) == 0
                              ? Interval(Rational(1, 1'000'000'000'000))
                              : abs(quantity.enclosure) * Interval(Rational(1, 1'000'000'000'000));
  if (sign(abs(quantity.enclosure - Interval(*needed)) - margin) > 0) {
    faults.add(place, fmt::format("is not the {} of the design", bound.quantity_name));
  }
}

std::optional<DemandedClaim> check_entry(const Problem& problem, const Json& entry,
                                         const std::string& place, Faults& faults) {
  const auto key = text(member(entry, "key"));
  const auto bound = key ? find_relaxed_bound(problem, *key) : std::nullopt;
  if (!bound) {
    faults.add(place + "/key", "is no bound of this problem that can be relaxed");
    return std::nullopt;
  }
  if (!is_written_as(member(entry, "limit"), {Interval(bound->value), bound->value})) {
    faults.add(place + "/limit", "is not the problem's bound");
  }
  const auto design = read_candidate(problem, member(entry, "design"), place + "/design", faults);
  if (!design) return std::nullopt;
  check_needed(problem, *bound, *design, member(entry, "needed"), place + "/needed", faults);

  DemandedClaim claim;
  claim.kind = ClaimKind::kLeastRelaxation;
  claim.hypotheses = without_key(problem, bound->key);
  claim.quantity_name = bound->quantity_name;
  claim.quantity = bound->quantity;
  claim.key = bound->key;
  claim.reference = *design;
  return claim;
}

}  // namespace

std::vector<DemandedClaim> check_relaxations(const Problem& problem, const Json& result,
                                             Faults& faults) {
  const Json& entries = elements(member(result, "would_be_feasible_with"));
  std::vector<DemandedClaim> claims;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string place = fmt::format("/would_be_feasible_with/{}", i);
    const auto claim = check_entry(problem, entries[i], place, faults);
    if (!claim) return claims;
    const auto same_key = [&](const DemandedClaim& each) { return each.key == claim->key; };
    if (std::any_of(claims.begin(), claims.end(), same_key)) {
      faults.add(place + "/key", "stands there twice");
      return claims;
    }
    claims.push_back(*claim);
  }
  return claims;
}

}  // namespace torquewright::gearbox::proof
