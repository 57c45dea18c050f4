// SPDX-License-Identifier: Apache-2.0
#include "gearbox/search/conflict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "gearbox/search/alternatives.hpp"
#include "gearbox/search/looser_bound.hpp"

namespace torquewright::gearbox {
namespace {

using optimization::VisitStatus;

// Without the rotor's bore no ring is too large. "Never feasible" is then proved for rings of up to
// so many teeth, which is said in the claim.
constexpr std::int64_t kUnboundedRing = 100'000;
// Beyond this a constraint counts as needed, without a design to show it.
constexpr std::int64_t kMaxBoxes = 20'000;

using Names = std::set<std::string>;

bool limits_ring(const Names& names) { return names.contains("rotor_bore"); }

Alternatives restricted(const Problem& problem, const Names& names) {
  return Alternatives(
      problem, [&](const std::string& name, const std::string&) { return names.contains(name); },
      [&](const Rational& module_mm) {
        return limits_ring(names) ? ring_limit_of_bore(problem, module_mm) : kUnboundedRing;
      },
      "");
}

// What is known of a set of constraints.
struct Trial {
  VisitStatus status;            ///< kAll: no design satisfies them.
  std::optional<Design> design;  ///< One that does.
};

Trial try_without(const Problem& problem, const Names& names, const DesignSearchOptions& options) {
  const Alternatives alternatives = restricted(problem, names);
  Trial trial{VisitStatus::kAll, std::nullopt};
  trial.status = optimization::for_each_feasible(
      alternatives.judges(), {kMaxBoxes, options.should_stop},
      [&](std::size_t alternative, std::span<const std::int64_t> point) {
        trial.design = alternatives.design(alternative, point);
        return false;
      });
  return trial;
}

std::string teeth_text(const Design& design) {
  return fmt::format("{} with n = {}", fmt::join(design.teeth, "/"), design.planet_count);
}

// Constraints are dropped one after the other, the geometric ones first and those that a user sets
// last, as long as what is left has no design: the rest is irreducible.
std::vector<ConflictMember> irreducible_set(const Problem& problem, std::vector<std::string> order,
                                            const DesignSearchOptions& options) {
  Names kept(order.begin(), order.end());
  std::vector<ConflictMember> members;
  for (auto name = order.rbegin(); name != order.rend(); ++name) {
    Names without = kept;
    without.erase(*name);
    const Trial trial = try_without(problem, without, options);
    if (trial.status == VisitStatus::kAll) {
      kept = std::move(without);
      continue;
    }
    members.push_back({*name, trial.design, conflict_sentence(*name, trial.design)});
  }
  std::reverse(members.begin(), members.end());
  return members;
}

// The claim that they conflict, with its search. Absent if that was ended.
struct ProvedConflict {
  Claim claim;
  optimization::SearchResult search;
};

std::optional<ProvedConflict> prove_conflict(const Problem& problem,
                                             const std::vector<ConflictMember>& members,
                                             const DesignSearchOptions& options) {
  Names names;
  Claim claim;
  claim.kind = "infeasible";
  for (const ConflictMember& member : members) {
    names.insert(member.constraint);
    claim.constraints.push_back(member.constraint);
  }
  if (!limits_ring(names)) claim.ring_limit = kUnboundedRing;
  const Alternatives alternatives = restricted(problem, names);
  optimization::SearchOptions search;
  search.relaxation = options.relaxation;
  search.should_stop = options.should_stop;
  optimization::SearchResult found = optimization::minimise(alternatives.judges(), search);
  if (found.status != optimization::SearchStatus::kComplete) return std::nullopt;
  claim.alternatives = alternatives.proofs(std::move(found.proofs));
  return ProvedConflict{std::move(claim), std::move(found)};
}

}  // namespace

std::string conflict_sentence(const std::string& constraint,
                              const std::optional<Design>& without_it) {
  if (without_it) {
    return fmt::format("Without {} there is {}.", constraint, teeth_text(*without_it));
  }
  return fmt::format("Whether {} is needed for the conflict was not settled.", constraint);
}

void explain_infeasibility(const Problem& problem, const DesignSearchOptions& options,
                           std::vector<AlternativeProof> proofs,
                           const optimization::SearchResult& first, DesignSearchResult& result) {
  result.status = DesignSearchStatus::kInfeasible;
  const std::vector<std::string> all = Alternatives(problem).constraints();
  result.conflict = irreducible_set(problem, all, options);
  if (auto proved = prove_conflict(problem, result.conflict, options)) {
    add_to(result.search, proved->search);
    result.claims = {std::move(proved->claim)};
  } else {  // then what is proved is that all of them conflict
    add_to(result.search, first);
    result.conflict.clear();
    for (const std::string& name : all) {
      result.conflict.push_back({name, std::nullopt, conflict_sentence(name, std::nullopt)});
    }
    result.claims = {{"infeasible", all, "", std::nullopt, "", std::nullopt, std::move(proofs)}};
  }
  for (const std::string& key : keys_of(problem, result.conflict)) {
    if (auto found = least_change(problem, key, options)) {
      result.would_be_feasible_with.push_back(std::move(found->bound));
      result.claims.push_back(std::move(found->claim));
      add_to(result.search, found->search);
    }
  }
}

}  // namespace torquewright::gearbox
