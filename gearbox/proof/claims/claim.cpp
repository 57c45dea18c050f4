// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/claims/claim.hpp"

#include <algorithm>

namespace torquewright::gearbox::proof {
namespace {

bool can_be_judged_on_boxes(const Constraint& constraint) {
  switch (constraint.family) {
    case ConstraintFamily::kRatio:  // under two names of its own
    case ConstraintFamily::kEqualSpacing:
    case ConstraintFamily::kIdenticalPlanets:
    case ConstraintFamily::kInvoluteInterference:
    case ConstraintFamily::kTrochoidInterference:
      return false;
    case ConstraintFamily::kContactRatio:
      return constraint.place == 0;  // external: grows with the teeth of both gears
    default:
      return true;
  }
}

}  // namespace

bool Claim::holds(ConstraintFamily family) const {
  return std::any_of(hypotheses.begin(), hypotheses.end(),
                     [&](const Constraint& each) { return each.family == family; });
}

Alternative alternative_of(const Problem& problem, const Claim& claim, std::int64_t planet_count,
                           const Rational& module_mm) {
  Alternative alternative(problem, planet_count, module_mm);
  if (claim.ring_limit) alternative.largest_ring = *claim.ring_limit;
  if (claim.kind == ClaimKind::kLeastRelaxation && !claim.holds(ConstraintFamily::kRotorBore)) {
    alternative.largest_ring = *claim.threshold->exact / module_mm;
  }
  return alternative;
}

std::int64_t largest_ring_teeth(const Alternative& alternative) {
  const Rational& limit = alternative.largest_ring;
  if (limit <= 0) return 0;
  const mpz_class teeth = limit.get_num() / limit.get_den();
  return teeth > static_cast<long>(kMostTeeth) ? kMostTeeth + 1 : teeth.get_si();
}

Box root_box(const Alternative& alternative) {
  const std::int64_t most = largest_ring_teeth(alternative);
  Box box{{1, 1, 1}, {most, most / 2, most / 2}};
  if (!alternative.train->is_stepped()) box.lower[2] = box.upper[2] = 0;
  return box;
}

std::optional<Condition> find_condition(const Claim& claim, std::string_view name) {
  if (name == "quantity") {
    if (!claim.threshold) return std::nullopt;
    return Condition{Condition::Kind::kQuantity, std::nullopt};
  }
  if (name == "ratio_max" || name == "ratio_min") {
    const Constraint* ratio = find_constraint(claim.hypotheses, "ratio");
    if (ratio == nullptr) return std::nullopt;
    return Condition{name == "ratio_max" ? Condition::Kind::kRatioMax : Condition::Kind::kRatioMin,
                     *ratio};
  }
  const Constraint* constraint = find_constraint(claim.hypotheses, name);
  if (constraint == nullptr || !can_be_judged_on_boxes(*constraint)) return std::nullopt;
  return Condition{Condition::Kind::kConstraint, *constraint};
}

}  // namespace torquewright::gearbox::proof
