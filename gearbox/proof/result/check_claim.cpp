// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "gearbox/proof/result/result_parts.hpp"

namespace torquewright::gearbox::proof {
namespace {

/// A claim about fewer ring teeth says too little to be called a conflict.
constexpr std::int64_t kLeastRingLimit = 200;

std::string_view kind_name(ClaimKind kind) {
  switch (kind) {
    case ClaimKind::kOptimum:
      return "optimum";
    case ClaimKind::kInfeasible:
      return "infeasible";
    case ClaimKind::kLeastRelaxation:
      return "least_relaxation";
  }
  return "";
}

std::string names_of(const std::vector<Constraint>& constraints) {
  std::string names;
  for (const Constraint& each : constraints) names += (names.empty() ? "" : ", ") + each.name;
  return names;
}

void check_hypotheses(const DemandedClaim& demanded, const Json& json, const std::string& place,
                      Faults& faults) {
  const Json& written = elements(member(json, "constraints"));
  std::multiset<std::string> names;
  for (const Json& each : written) names.insert(text(&each).value_or(""));
  std::multiset<std::string> demanded_names;
  for (const Constraint& each : demanded.hypotheses) demanded_names.insert(each.name);
  if (names != demanded_names) {
    faults.add(place + "/constraints", "is not exactly: " + names_of(demanded.hypotheses));
  }
}

void check_text_or_null(const Json& json, const char* key, const std::string& demanded,
                        const std::string& place, Faults& faults) {
  const Json* written = present(json, key);
  if (demanded.empty() ? written != nullptr : text(written) != demanded) {
    faults.add(fmt::format("{}/{}", place, key),
               demanded.empty() ? "has to be null here" : "is not " + demanded);
  }
}

std::optional<Candidate> check_reference(const Problem& problem, const DemandedClaim& demanded,
                                         const Json& json, const std::string& place,
                                         Faults& faults) {
  const Json* written = present(json, "reference");
  if (written == nullptr) {
    if (demanded.reference && !demanded.reference_is_open) {
      faults.add(place + "/reference", "is missing");
    }
    return std::nullopt;
  }
  const auto reference = read_candidate(problem, written, place + "/reference", faults);
  if (reference && reference != demanded.reference) {
    faults.add(place + "/reference", "is not the design that the claim is about");
  }
  return reference;
}

/// The ring limit stands in for the rotor's bore where that is no hypothesis and nothing else
/// bounds the rings.
std::optional<Rational> check_ring_limit(const Problem& problem, const Claim& claim,
                                         const Json& json, const std::string& place,
                                         Faults& faults) {
  const Json* written = present(json, "ring_limit");
  if (claim.holds(ConstraintFamily::kRotorBore) || claim.kind == ClaimKind::kLeastRelaxation) {
    if (written != nullptr) faults.add(place + "/ring_limit", "has to be null here");
    return std::nullopt;
  }
  std::int64_t least = kLeastRingLimit;
  for (const Rational& module_mm : problem.module_mm) {
    least = std::max(
        least, largest_ring_teeth(Alternative(problem, problem.planet_count.front(), module_mm)));
  }
  const auto limit = whole_number(written);
  if (!limit || *limit < least || *limit > kMostTeeth) {
    faults.add(place + "/ring_limit",
               fmt::format("is no number of teeth between {} and {}", least, kMostTeeth));
    return std::nullopt;
  }
  return Rational(static_cast<long>(*limit));
}

/// Cheap and often violated first: points are judged by the million.
void order_by_cost(std::vector<Constraint>& hypotheses) {
  const auto cost = [](const Constraint& each) {
    switch (each.family) {
      case ConstraintFamily::kPositiveTeeth:
        return -1;
      case ConstraintFamily::kMinTeeth:
      case ConstraintFamily::kToothDifference:
      case ConstraintFamily::kSunUnderLayer2:
      case ConstraintFamily::kEqualSpacing:
        return 0;
      case ConstraintFamily::kRotorBore:
        return 1;
      case ConstraintFamily::kRatio:
        return 2;
      case ConstraintFamily::kIdenticalPlanets:
      case ConstraintFamily::kRingWall:
        return 3;
      default:
        return 4;
    }
  };
  std::stable_sort(hypotheses.begin(), hypotheses.end(),
                   [&](const Constraint& a, const Constraint& b) { return cost(a) < cost(b); });
}

void check_alternatives(const Problem& problem, const Claim& claim, const Json& json,
                        const std::string& place, Account& account) {
  std::set<std::pair<std::int64_t, Rational>> missing;
  for (const std::int64_t count : problem.planet_count) {
    for (const Rational& module_mm : problem.module_mm) missing.emplace(count, module_mm);
  }
  const Json& alternatives = elements(member(json, "alternatives"));
  for (std::size_t i = 0; i < alternatives.size(); ++i) {
    const Json& each = alternatives[i];
    const std::string here = fmt::format("{}/alternatives/{}", place, i);
    check_keys(each, {"planet_count", "module_mm", "nodes"}, here, account.faults);
    const auto count = whole_number(member(each, "planet_count"));
    const auto module_mm = decimal(member(each, "module_mm"));
    if (!count || !module_mm || missing.erase({*count, *module_mm}) == 0) {
      account.faults.add(here, "is no alternative of the problem, or one for the second time");
      return;
    }
    const Json* nodes = member(each, "nodes");
    check_tree(claim, alternative_of(problem, claim, *count, *module_mm),
               nodes != nullptr ? *nodes : Json(), here + "/nodes", account);
  }
  if (!missing.empty()) {
    account.faults.add(place + "/alternatives",
                       fmt::format("lacks {} of the problem's alternatives", missing.size()));
  }
}

}  // namespace

void check_claim(const Problem& problem, const DemandedClaim& demanded, const Json& json,
                 const std::string& place, Account& account) {
  Faults& faults = account.faults;
  const std::size_t faults_before = faults.count();
  check_keys(json,
             {"kind", "constraints", "quantity", "reference", "key", "ring_limit", "alternatives"},
             place, faults);
  check_text_or_null(json, "kind", std::string(kind_name(demanded.kind)), place, faults);
  check_text_or_null(json, "quantity", demanded.quantity_name, place, faults);
  check_text_or_null(json, "key", demanded.key, place, faults);
  check_hypotheses(demanded, json, place, faults);

  Claim claim;
  claim.kind = demanded.kind;
  claim.hypotheses = demanded.hypotheses;
  claim.quantity = demanded.quantity;
  claim.listed = {demanded.listed.begin(), demanded.listed.end()};
  claim.may_be_open = demanded.may_be_open;
  claim.open_bound = demanded.open_bound;
  claim.reference = check_reference(problem, demanded, json, place, faults);
  claim.ring_limit = check_ring_limit(problem, claim, json, place, faults);
  if (faults.count() != faults_before) return;

  // Never listed, but what makes a point a design: without it the others mean nothing.
  if (train_of(problem).is_stepped()) {
    claim.hypotheses.push_back({"positive_teeth", ConstraintFamily::kPositiveTeeth, 0, ""});
  }
  if (claim.ring_limit) {
    claim.hypotheses.push_back({"rotor_bore", ConstraintFamily::kRotorBore, 1, ""});
  }
  if (claim.reference) {
    const Candidate& design = *claim.reference;
    claim.threshold = value_at(
        *claim.quantity, Alternative(problem, design.planet_count, design.module_mm), design.point);
  }
  order_by_cost(claim.hypotheses);
  check_alternatives(problem, claim, json, place, account);
}

}  // namespace torquewright::gearbox::proof
