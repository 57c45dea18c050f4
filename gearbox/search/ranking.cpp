// SPDX-License-Identifier: Apache-2.0
#include "gearbox/search/ranking.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearbox/search/alternatives.hpp"

namespace torquewright::gearbox {
namespace {

using optimization::Judge;
using optimization::VisitStatus;

constexpr std::size_t kMostDesigns = 2'000'000;

struct Rival {
  std::size_t alternative;
  std::vector<std::int64_t> point;
};

bool is_minimum_or_clearance(const std::string& constraint) {
  return constraint == "carrier_clearance" || constraint.starts_with("min_teeth.");
}

// All designs that satisfy everything but minima and carrier clearance.
struct Field {
  Alternatives alternatives;
  std::vector<Rival> rivals;
  bool is_complete = false;
};

Field gather(const Problem& problem, const std::function<bool()>& should_stop) {
  Field field{
      Alternatives(
          problem,
          [](const std::string& constraint, const std::string&) {
            return !is_minimum_or_clearance(constraint);
          },
          [&](const Rational& module_mm) { return ring_limit_of_bore(problem, module_mm); }, ""),
      {},
      false};
  optimization::VisitOptions options;
  options.should_stop = should_stop;
  const VisitStatus status = optimization::for_each_feasible(
      field.alternatives.judges(), options,
      [&](std::size_t alternative, std::span<const std::int64_t> point) {
        field.rivals.push_back({alternative, {point.begin(), point.end()}});
        return field.rivals.size() < kMostDesigns;
      });
  field.is_complete = status == VisitStatus::kAll;
  return field;
}

// pi/n - asin(P1/(S + P1)), for comparisons between designs; exact where it is zero.
double clearance_rad(const Design& design) {
  if (design.planet_count == 6 && design.teeth[0] == design.teeth[1]) return 0.0;
  const double sun = static_cast<double>(design.teeth[0]);
  const double planet = static_cast<double>(design.teeth[1]);
  return std::numbers::pi / static_cast<double>(design.planet_count) -
         std::asin(planet / (sun + planet));
}

// How rivals compare with a design by the problem's objective.
class Comparison {
 public:
  Comparison(const Judge& judge, std::span<const std::int64_t> point)
      : cost_(judge.cost_at(point)), nearest_(cost_.nearest()) {}

  /// -1, 0, 1: the rival is better, as good, worse.
  int order_of(const Judge& judge, const Rival& rival) const {
    const double least = judge.least_cost_at(rival.point);
    if (least > nearest_ + kFar * std::abs(nearest_)) return 1;
    return judge.compare(judge.cost_at(rival.point), cost_);
  }

 private:
  static constexpr double kFar = 1e-9;  // doubles settle what is further apart
  optimization::PreciseInterval cost_;
  double nearest_;
};

bool satisfies_problem(const Alternatives& whole, const Rival& rival) {
  const Judge& judge = whole.judges()[rival.alternative];
  for (std::size_t i = 0; i < judge.condition_count(); ++i) {
    if (is_minimum_or_clearance(judge.condition(i).constraint) && !judge.holds(i, rival.point)) {
      return false;
    }
  }
  return true;
}

void find_best(const Judge& judge, const Rival& rival, Standing& standing) {
  const double cost = judge.cost_at(rival.point).nearest();
  const bool maximise = judge.problem().goal.maximise;
  const double objective = maximise ? -cost : cost;
  if (!standing.best_objective ||
      (maximise ? objective > *standing.best_objective : objective < *standing.best_objective)) {
    standing.best_objective = objective;
  }
}

}  // namespace

Standing standing_of(const Problem& problem, const Design& design,
                     const std::function<bool()>& should_stop) {
  const Field field = gather(problem, should_stop);
  const Alternatives whole(problem);
  const std::size_t free_gears = find_topology(problem.topology)->free_gears;
  const auto own = std::find_if(field.rivals.begin(), field.rivals.end(), [&](const Rival& rival) {
    return field.alternatives.design(rival.alternative, rival.point) == design;
  });
  Standing standing;
  standing.is_complete = field.is_complete;
  std::optional<Comparison> comparison;
  if (own != field.rivals.end()) {
    comparison.emplace(field.alternatives.judges()[own->alternative], own->point);
  }
  std::int64_t better = 0;
  std::vector<BetterDesign> all_better;
  for (const Rival& rival : field.rivals) {
    const Judge& judge = field.alternatives.judges()[rival.alternative];
    const bool is_feasible = satisfies_problem(whole, rival);
    if (is_feasible) {
      ++standing.feasible_count;
      find_best(judge, rival, standing);
    }
    if (!comparison || &rival == &*own) continue;
    const int order = comparison->order_of(judge, rival);
    if (order > 0) continue;
    Design beating = field.alternatives.design(rival.alternative, rival.point);
    if (order == 0) {
      if (is_feasible) standing.ties.push_back(std::move(beating));
      continue;
    }
    better += is_feasible ? 1 : 0;
    const double clearance = clearance_rad(beating);
    beating.teeth.resize(free_gears);
    all_better.push_back({std::move(beating.teeth), clearance});
  }
  if (!comparison || !standing.is_complete) return standing;
  if (satisfies_problem(whole, *own)) {
    standing.rank = better + 1;
  } else {
    standing.ties.clear();
  }
  std::vector<std::int64_t> free_teeth = design.teeth;
  free_teeth.resize(free_gears);
  standing.optimal_when = optimal_when(free_teeth, clearance_rad(design), std::move(all_better));
  return standing;
}

}  // namespace torquewright::gearbox
