// SPDX-License-Identifier: Apache-2.0
#include "gearbox/search/alternatives.hpp"

#include <algorithm>
#include <stdexcept>

namespace torquewright::gearbox {
namespace {

// Part of what a design is, not of what is asked of it: never named in a claim.
constexpr const char* kDomain = "positive_teeth";

// Far more teeth than any gear has; keeps products of tooth counts exact in doubles.
constexpr std::int64_t kMostRingTeeth = 1'000'000;

bool holds(const optimization::Box& domain, std::span<const std::int64_t> point) {
  return std::equal(domain.begin(), domain.end(), point.begin(), point.end(),
                    [](const auto& range, std::int64_t value) { return range.contains(value); });
}

/// Where a ratio is not asked for, nothing may rest on it.
Problem of_any_ratio(Problem problem) {
  problem.ratio_tolerance = 1'000'000;
  return problem;
}

void keep_only(optimization::Problem& model,
               const std::function<bool(const std::string&, const std::string&)>& keeps) {
  std::erase_if(model.conditions, [&](const auto& condition) {
    return condition.constraint != kDomain && !keeps(condition.constraint, condition.key);
  });
  std::erase_if(model.predicates,
                [&](const auto& predicate) { return !keeps(predicate.constraint, predicate.key); });
}

}  // namespace

std::int64_t floor_of(const Rational& value) {
  const mpz_class whole = value.get_num() / value.get_den();  // rounds towards zero; value >= 0
  return whole.fits_slong_p() ? whole.get_si() : kMostRingTeeth;
}

void add_to(SearchCounts& counts, const optimization::SearchResult& search) {
  counts.nodes += search.nodes;
  counts.relaxations += search.relaxations;
  counts.refuted_by_relaxation += search.refuted_by_relaxation;
  counts.points_enumerated += search.points_enumerated;
}

std::int64_t ring_limit_of_bore(const Problem& problem, const Rational& module_mm) {
  return std::min(kMostRingTeeth, floor_of(problem.rotor_inner_diameter_mm / module_mm));
}

Alternatives::Alternatives(const Problem& problem)
    : Alternatives(
          problem, [](const std::string&, const std::string&) { return true; },
          [&](const Rational& module_mm) { return ring_limit_of_bore(problem, module_mm); }, "") {}

Alternatives::Alternatives(const Problem& problem,
                           const std::function<bool(const std::string&, const std::string&)>& keeps,
                           const std::function<std::int64_t(const Rational&)>& ring_limit,
                           const std::string& loosened_key)
    : topology_(find_topology(problem.topology)) {
  if (topology_ == nullptr) throw std::logic_error("unknown topology: the reader refuses it");
  const Problem asked = keeps("ratio", "/ratio_tolerance") ? problem : of_any_ratio(problem);
  for (const std::int64_t planet_count : problem.planet_count) {
    for (const Rational& module_mm : problem.module_mm) {
      optimization::Problem model =
          topology_->model(asked, planet_count, module_mm, ring_limit(module_mm));
      keep_only(model, keeps);
      for (const optimization::Loosening& loosening : model.loosenings) {
        if (loosening.key == loosened_key) model.goal = loosening.quantity;
      }
      choices_.emplace_back(planet_count, module_mm);
      judges_.emplace_back(model);
    }
  }
}

Design Alternatives::design(std::size_t alternative, std::span<const std::int64_t> point) const {
  const auto& [planet_count, module_mm] = choices_[alternative];
  return {topology_->complete(topology_->free_teeth(point)), planet_count, module_mm};
}

std::optional<Place> Alternatives::place_of(const Design& design) const {
  const std::span<const std::int64_t> free_teeth(design.teeth.data(), topology_->free_gears);
  const std::vector<std::int64_t> point = topology_->point_of(free_teeth);
  for (std::size_t i = 0; i < choices_.size(); ++i) {
    const bool is_in_domain = holds(judges_[i].problem().domain, point);
    if (is_in_domain && this->design(i, point) == design) return Place{i, point};
  }
  return std::nullopt;
}

std::vector<std::string> Alternatives::constraints() const {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    const bool is_known = std::find(names.begin(), names.end(), name) != names.end();
    if (name != kDomain && !is_known) names.push_back(name);
  };
  const optimization::Problem& model = judges_.front().problem();
  for (const auto& condition : model.conditions) add(condition.constraint);
  for (const auto& predicate : model.predicates) add(predicate.constraint);
  return names;
}

std::vector<AlternativeProof> Alternatives::proofs(
    std::vector<optimization::ProofTree> trees) const {
  std::vector<AlternativeProof> result;
  for (std::size_t i = 0; i < judges_.size(); ++i) {
    std::vector<std::string> conditions;
    for (const auto& condition : judges_[i].problem().conditions) {
      conditions.push_back(condition.name);
    }
    result.push_back({choices_[i].first, choices_[i].second, judges_[i].problem().variables,
                      std::move(conditions), std::move(trees[i])});
  }
  return result;
}

}  // namespace torquewright::gearbox
