// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gearbox/problem.hpp"
#include "gearbox/search/search_result.hpp"
#include "gearbox/topologies/topology.hpp"
#include "optimization/discrete/branch_and_bound.hpp"
#include "optimization/discrete/judge.hpp"

namespace torquewright::gearbox {

/// A point of one of several models.
struct Place {
  std::size_t alternative;
  std::vector<std::int64_t> point;
  bool operator==(const Place&) const = default;
};

/// The models of a problem, one for each planet count and module, which are searched together.
class Alternatives {
 public:
  /// Makes the models with all constraints, in the rotor's bore.
  explicit Alternatives(const Problem& problem);
  /// Makes the models with the conditions and predicates that `keeps` accepts (by constraint and
  /// key), rings of at most ring_limit(module) teeth, and the given key's quantity for a goal
  /// (empty: the objective).
  Alternatives(
      const Problem& problem,
      const std::function<bool(const std::string& constraint, const std::string& key)>& keeps,
      const std::function<std::int64_t(const Rational& module_mm)>& ring_limit,
      const std::string& loosened_key);

  const std::vector<optimization::Judge>& judges() const { return judges_; }
  bool empty() const { return judges_.empty(); }
  const optimization::Goal& goal() const { return judges_.front().problem().goal; }

  Design design(std::size_t alternative, std::span<const std::int64_t> point) const;
  Design design(const optimization::Solution& solution) const {
    return design(solution.alternative, solution.point);
  }
  /// Finds a design's point; absent where no model's domain holds it.
  std::optional<Place> place_of(const Design& design) const;
  /// Returns the names of all constraints, in order, without those that only bound the domain.
  std::vector<std::string> constraints() const;
  std::vector<AlternativeProof> proofs(std::vector<optimization::ProofTree> trees) const;

 private:
  const Topology* topology_;
  std::vector<std::pair<std::int64_t, Rational>> choices_;
  std::vector<optimization::Judge> judges_;
};

/// Adds the counts of a search.
void add_to(SearchCounts& counts, const optimization::SearchResult& search);

/// Returns floor(D/m): the largest ring whose pitch circle fits the rotor's bore.
std::int64_t ring_limit_of_bore(const Problem& problem, const Rational& module_mm);

/// Returns the largest integer that is not above the value.
std::int64_t floor_of(const Rational& value);

}  // namespace torquewright::gearbox
