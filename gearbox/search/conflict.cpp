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
// Beyond this a design that meets one more constraint is not looked for.
constexpr std::int64_t kWitnessBoxes = 2'000;

using Names = std::set<std::string>;

bool limits_ring(const Names& names) { return names.contains("rotor_bore"); }

// `goal_key`: a bound's, how far it would have to move; empty: the problem's objective.
Alternatives restricted(const Problem& problem, const Names& names,
                        const std::string& goal_key = "") {
  return Alternatives(
      problem, [&](const std::string& name, const std::string&) { return names.contains(name); },
      [&](const Rational& module_mm) {
        return limits_ring(names) ? ring_limit_of_bore(problem, module_mm) : kUnboundedRing;
      },
      goal_key);
}

// What is known of a set of constraints.
struct Trial {
  VisitStatus status;            ///< kAll: no design satisfies them.
  std::optional<Design> design;  ///< One that does.
};

Trial try_without(const Problem& problem, const Names& names, std::int64_t max_boxes,
                  const DesignSearchOptions& options) {
  const Alternatives alternatives = restricted(problem, names);
  Trial trial{VisitStatus::kAll, std::nullopt};
  trial.status = optimization::for_each_feasible(
      alternatives.judges(), {max_boxes, options.should_stop},
      [&](std::size_t alternative, std::span<const std::int64_t> point) {
        trial.design = alternatives.design(alternative, point);
        return false;
      });
  return trial;
}

std::string teeth_text(const Design& design) {
  return fmt::format("{} with {} planet{}", fmt::join(design.teeth, "/"), design.planet_count,
                     design.planet_count == 1 ? "" : "s");
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
    const Trial trial = try_without(problem, without, kMaxBoxes, options);
    if (trial.status == VisitStatus::kAll) {
      kept = std::move(without);
      continue;
    }
    members.push_back({*name, trial.design, conflict_sentence(*name, trial.design)});
  }
  std::reverse(members.begin(), members.end());
  return members;
}

// Whether it meets every constraint of the problem but that one.
bool misses_only(const Problem& problem, const Design& design, const std::string& constraint) {
  const DesignReport report = find_topology(problem.topology)->evaluate(problem, design);
  return std::all_of(report.constraints.begin(), report.constraints.end(),
                     [&](const auto& each) { return each.satisfied == (each.name != constraint); });
}

std::string key_of(const Alternatives& alternatives, const std::string& constraint) {
  for (const auto& condition : alternatives.judges().front().problem().conditions) {
    if (condition.constraint == constraint) return condition.key;
  }
  return "";
}

// Of the designs without a member of the conflict one that shows what it stands in the way of: it
// meets as many of the problem's other constraints as go together with the conflict's, and misses
// the member by as little as can be.
std::optional<Design> telling_design(const Problem& problem, const std::string& constraint,
                                     Names kept, const DesignSearchOptions& options) {
  const Alternatives whole(problem);
  for (const std::string& name : whole.constraints()) {
    if (name == constraint || !kept.insert(name).second) continue;
    if (!try_without(problem, kept, kWitnessBoxes, options).design) kept.erase(name);
  }
  const Alternatives alternatives = restricted(problem, kept, key_of(whole, constraint));
  optimization::SearchOptions search;
  search.relaxation = optimization::RelaxationUse::kNever;
  search.max_nodes = kMaxBoxes;
  search.should_stop = options.should_stop;
  const auto found = optimization::minimise(alternatives.judges(), search);
  if (found.solutions.empty()) return std::nullopt;
  return alternatives.design(found.solutions.front());
}

// A design that misses nothing but the member, and that by the least change there is, is among the
// remedies, if there is one.
void name_telling_designs(const Problem& problem, const DesignSearchOptions& options,
                          DesignSearchResult& result) {
  Names conflict;
  for (const ConflictMember& member : result.conflict) conflict.insert(member.constraint);
  for (ConflictMember& member : result.conflict) {
    if (!member.without_it) continue;
    const auto& remedies = result.would_be_feasible_with;
    const auto remedy = std::find_if(remedies.begin(), remedies.end(), [&](const auto& bound) {
      return misses_only(problem, bound.design, member.constraint);
    });
    std::optional<Design> design;
    if (remedy != remedies.end()) {
      design = remedy->design;
    } else {
      Names others = conflict;
      others.erase(member.constraint);
      design = telling_design(problem, member.constraint, std::move(others), options);
    }
    if (!design) continue;
    member.without_it = std::move(design);
    member.sentence = conflict_sentence(member.constraint, member.without_it);
  }
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
  name_telling_designs(problem, options, result);
}

}  // namespace torquewright::gearbox
