// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "optimization/discrete/incumbents.hpp"
#include "optimization/discrete/problem.hpp"
#include "optimization/discrete/proof_tree.hpp"

namespace torquewright::optimization {

/// When Ipopt is asked about a box that propagation has left open.
enum class RelaxationUse {
  kAuto,    ///< Ipopt is used where a shape of the cost is known, for at most a tenth of the time.
  kAlways,  ///< Ipopt is used for every box that is not enumerated.
  kNever,
};

struct Progress {
  std::int64_t nodes = 0;
  std::size_t open = 0;
  std::size_t found = 0;
  double best_cost = std::numeric_limits<double>::infinity();
  double bound = -std::numeric_limits<double>::infinity();
};

struct SearchOptions {
  std::size_t wanted = 1;  ///< Number of best points that are wanted, at least 1.
  RelaxationUse relaxation = RelaxationUse::kAuto;
  std::int64_t max_nodes = std::numeric_limits<std::int64_t>::max();
  /// Called before every node; true ends the search with what is known.
  std::function<bool()> should_stop = [] { return false; };
  std::function<void(const Progress&)> report = [](const Progress&) {};
  /// For tests: fails loudly when a box that holds this point is closed although the point is good.
  std::function<void(std::size_t alternative, const Box& box, double ceiling)> on_close =
      [](std::size_t, const Box&, double) {};
};

enum class SearchStatus {
  kComplete,  ///< Every box was closed by a proof.
  kLimit,     ///< Some boxes are open; their bound is what is known.
};

struct SearchResult {
  SearchStatus status = SearchStatus::kLimit;
  /// Solutions, best first; all ties with the last wanted one follow.
  std::vector<Solution> solutions;
  double bound = std::numeric_limits<double>::infinity();  ///< No point costs less than this.
  std::int64_t nodes = 0;
  std::int64_t relaxations = 0;  ///< Number of Ipopt solves.
  std::int64_t refuted_by_relaxation = 0;
  std::int64_t points_enumerated = 0;
  std::vector<ProofTree> proofs;  ///< One proof for each alternative.
};

/// Finds the best points of several problems with the same variables and the same kind of goal (the
/// alternatives: they differ in constants), by branch and bound: interval propagation, Ipopt
/// relaxations where they pay, enumeration of small boxes, bisection of the others.
SearchResult minimise(std::span<const Judge> alternatives, const SearchOptions& options);

enum class VisitStatus {
  kAll,      ///< Every feasible point was visited.
  kStopped,  ///< The visitor ended the search.
  kLimit,    ///< A limit was reached: too many boxes, or should_stop(). There may be more points.
};

struct VisitOptions {
  std::int64_t max_boxes = std::numeric_limits<std::int64_t>::max();
  std::function<bool()> should_stop = [] { return false; };
  /// Points that certainly cost more (Judge::ceiling) are left out; where it is infinite the cost
  /// does not count.
  double ceiling = std::numeric_limits<double>::infinity();
  std::function<void(std::int64_t boxes)> report = [](std::int64_t) {};
};

/// Calls `visit` for every feasible point, in the order of alternatives and of boxes, until it
/// returns false.
VisitStatus for_each_feasible(
    std::span<const Judge> alternatives, const VisitOptions& options,
    const std::function<bool(std::size_t alternative, std::span<const std::int64_t> point)>& visit);

}  // namespace torquewright::optimization
