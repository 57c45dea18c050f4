// SPDX-License-Identifier: Apache-2.0
#include "gearbox/search/ranking.hpp"

#include <cmath>
#include <numbers>

#include "gearbox/search/alternatives.hpp"

namespace torquewright::gearbox {
namespace {

using optimization::Judge;
using optimization::VisitStatus;

bool is_minimum_or_clearance(const std::string& constraint) {
  return constraint == "carrier_clearance" || constraint.starts_with("min_teeth.");
}

// The problem without minima and carrier clearance.
Alternatives without_minima_and_clearance(const Problem& problem) {
  return Alternatives(
      problem,
      [](const std::string& constraint, const std::string&) {
        return !is_minimum_or_clearance(constraint);
      },
      [&](const Rational& module_mm) { return ring_limit_of_bore(problem, module_mm); }, "");
}

// pi/n - asin(P1/(S + P1)), for comparisons between designs; exact where it is zero.
double clearance_rad(const Design& design) {
  if (design.planet_count == 6 && design.teeth[0] == design.teeth[1]) return 0.0;
  const double sun = static_cast<double>(design.teeth[0]);
  const double planet = static_cast<double>(design.teeth[1]);
  return std::numbers::pi / static_cast<double>(design.planet_count) -
         std::asin(planet / (sun + planet));
}

TeethAndClearance what_limits_see(const Problem& problem, const Design& design) {
  std::vector<std::int64_t> free_teeth = design.teeth;
  free_teeth.resize(find_topology(problem.topology)->free_gears);
  return {std::move(free_teeth), clearance_rad(design)};
}

optimization::VisitOptions visit_options(const StandingOptions& options, const char* sought,
                                         const std::int64_t& found) {
  optimization::VisitOptions result;
  result.max_boxes = options.max_boxes;
  result.should_stop = options.should_stop;
  result.report = [&options, sought, &found](std::int64_t boxes) {
    options.report(sought, boxes, found);
  };
  return result;
}

void find_best(const Alternatives& whole, const StandingOptions& options, Standing& standing) {
  optimization::SearchOptions search;
  search.relaxation = optimization::RelaxationUse::kNever;  // a solve costs as much as a cheap rank
  search.max_nodes = options.max_boxes;
  search.should_stop = options.should_stop;
  search.report = [&](const optimization::Progress& progress) {
    options.report("the best design", progress.nodes, static_cast<std::int64_t>(progress.found));
  };
  const optimization::SearchResult found = optimization::minimise(whole.judges(), search);
  const bool is_settled = found.status == optimization::SearchStatus::kComplete;
  if (!is_settled || found.solutions.empty()) return;
  const double cost = found.solutions.front().cost.nearest();
  standing.best_objective = whole.goal().maximise ? -cost : cost;
}

// How rivals compare with a design by the problem's objective.
class Comparison {
 public:
  Comparison(const Judge& judge, const optimization::PreciseInterval& cost)
      : judge_(judge), cost_(cost), clearly_better_(judge.floor(cost)) {}

  // -1, 0, 1: the rival is better, as good, worse. Absent: it has no such value.
  std::optional<int> order_of(const Judge& judge, std::span<const std::int64_t> rival) const {
    if (judge.cost_around(rival).upper < clearly_better_) return -1;
    const optimization::PreciseInterval cost = judge.cost_at(rival);
    return cost.is_nowhere() ? std::nullopt : std::optional(judge_.compare(cost, cost_));
  }

 private:
  const Judge& judge_;
  optimization::PreciseInterval cost_;
  double clearly_better_;
};

bool satisfies_problem(const Alternatives& whole, const Place& place) {
  const Judge& judge = whole.judges()[place.alternative];
  for (std::size_t i = 0; i < judge.condition_count(); ++i) {
    if (is_minimum_or_clearance(judge.condition(i).constraint) && !judge.holds(i, place.point)) {
      return false;
    }
  }
  return true;
}

// Sees every design that is at least as good, whatever its minima and its carrier clearance.
void find_rank(const Problem& problem, const Design& design, const Alternatives& whole,
               const StandingOptions& options, Standing& standing) {
  const Alternatives field = without_minima_and_clearance(problem);
  const std::optional<Place> own = field.place_of(design);
  standing.is_settled = true;
  if (!own || !field.judges()[own->alternative].is_feasible(own->point)) return;
  const Judge& judge = field.judges()[own->alternative];
  const optimization::PreciseInterval cost = judge.cost_at(own->point);
  if (cost.is_nowhere()) return;

  const bool is_feasible = satisfies_problem(whole, *own);
  std::int64_t better = 0;
  const Comparison comparison(judge, cost);
  BetterDesigns better_designs(what_limits_see(problem, design));
  optimization::VisitOptions visit = visit_options(options, "designs that are better", better);
  visit.ceiling = judge.ceiling(cost);
  const VisitStatus status = optimization::for_each_feasible(
      field.judges(), visit, [&](std::size_t alternative, std::span<const std::int64_t> point) {
        const Place rival{alternative, {point.begin(), point.end()}};
        const auto order = comparison.order_of(field.judges()[alternative], point);
        if (rival == *own || !order) return true;
        const Design beating = field.design(alternative, point);
        if (order < 0) better_designs.add(what_limits_see(problem, beating));
        if (order > 0 || !is_feasible || !satisfies_problem(whole, rival)) return true;
        if (order < 0) ++better;
        if (order == 0) standing.ties.push_back(beating);
        return true;
      });
  standing.is_settled = status == VisitStatus::kAll;
  if (!standing.is_settled) {
    standing.ties.clear();
    return;
  }
  if (is_feasible) standing.rank = better + 1;
  standing.optimal_when = better_designs.optimal_when();
}

void count_feasible(const Alternatives& whole, const StandingOptions& options, Standing& standing) {
  std::int64_t count = 0;
  const VisitStatus status =
      optimization::for_each_feasible(whole.judges(), visit_options(options, "all designs", count),
                                      [&](std::size_t, std::span<const std::int64_t>) {
                                        ++count;
                                        return true;
                                      });
  if (status == VisitStatus::kAll) standing.feasible_count = count;
}

}  // namespace

Standing standing_of(const Problem& problem, const Design& design, const StandingOptions& options) {
  Standing standing;
  const Alternatives whole(problem);
  find_best(whole, options, standing);
  find_rank(problem, design, whole, options, standing);
  count_feasible(whole, options, standing);
  return standing;
}

}  // namespace torquewright::gearbox
