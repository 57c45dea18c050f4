// SPDX-License-Identifier: Apache-2.0
#include "gearbox/front/front.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gearbox/search/alternatives.hpp"
#include "gearbox/synthesis/synthesis.hpp"
#include "gearbox/topologies/topology.hpp"
#include "optimization/discrete/branch_and_bound.hpp"

namespace torquewright::gearbox {
namespace {

using optimization::Condition;
using optimization::Expression;
using optimization::Goal;
using optimization::Judge;

/// Values that differ by less count as equal.
constexpr double kSame = 1e-9;

Problem with_objective(const Problem& problem, Objective objective) {
  Problem other = problem;
  other.objective = objective;
  return other;
}

/// Whole numbers: every point of the front, each found by asking for more than the last has.
class WholeFront {
 public:
  WholeFront(const Problem& problem, Objective second, const FrontOptions& options)
      : problem_(problem),
        other_(with_objective(problem, second)),
        options_(options),
        topology_(*find_topology(problem.topology)) {}

  Front run() {
    while (!options_.should_stop()) {
      const auto found = optimization::minimise(judges(), search_options());
      if (found.status != optimization::SearchStatus::kComplete) return std::move(front_);
      if (found.solutions.empty()) {
        front_.is_whole = true;
        return std::move(front_);
      }
      add(found);
      options_.report(front_.points.size());
    }
    return std::move(front_);
  }

 private:
  optimization::SearchOptions search_options() const {
    optimization::SearchOptions options;
    options.relaxation = optimization::RelaxationUse::kNever;
    options.should_stop = options_.should_stop;
    return options;
  }

  std::vector<Judge> judges() {
    std::vector<Judge> judges;
    choices_.clear();
    for (const std::int64_t planets : problem_.planet_count) {
      for (const Rational& module_mm : problem_.module_mm) {
        const std::int64_t ring = ring_limit_of_bore(problem_, module_mm);
        optimization::Problem model = topology_.model(problem_, planets, module_mm, ring);
        if (!front_.points.empty()) {
          const Goal second = topology_.model(other_, planets, module_mm, ring).goal;
          model.conditions.push_back(better_than(second, front_.points.back().second));
        }
        choices_.emplace_back(planets, module_mm);
        judges.emplace_back(model);
      }
    }
    return judges;
  }

  static Condition better_than(const Goal& goal, double value) {
    const double step = kSame * std::abs(value) * (goal.maximise ? 1.0 : -1.0);
    const Expression limit(io::exact(value + step));
    return {"front", "front", "", goal.maximise ? goal.value - limit : limit - goal.value};
  }

  /// Of designs that are alike in the first quantity, the one with the best second.
  void add(const optimization::SearchResult& found) {
    FrontPoint best;
    for (const optimization::Solution& solution : found.solutions) {
      const auto& [planets, module_mm] = choices_[solution.alternative];
      const Design design{topology_.complete(topology_.free_teeth(solution.point)), planets,
                          module_mm};
      FrontPoint point;
      point.report = topology_.evaluate(problem_, design);
      point.first = point.first_bound = point.report.objective;
      point.second = *objective_value(other_.objective, point.report);
      const double gain = point.second - best.second;
      const bool is_better = is_greater_better(other_.objective) ? gain > 0.0 : gain < 0.0;
      if (best.report.gears.empty() || is_better) best = std::move(point);
    }
    best.problem = problem_;
    if (!front_.points.empty()) best.from = front_.points.back().second;
    front_.points.push_back(std::move(best));
  }

  const Problem& problem_;
  Problem other_;
  const FrontOptions& options_;
  const Topology& topology_;
  std::vector<std::pair<std::int64_t, Rational>> choices_;
  Front front_;
};

/// With shifts and widths: limits between the lightest design's value and the best there is, which
/// a bisection encloses.
class SizedFront {
 public:
  SizedFront(const Problem& problem, Objective second, const FrontOptions& options)
      : problem_(problem), second_(second), options_(options) {}

  Front run() {
    front_.is_whole = true;
    if (!solve(std::nullopt)) return std::move(front_);
    enclose_best();
    while (front_.is_whole && front_.points.size() < options_.points) {
      const auto limit = amid_the_widest_gap();
      if (!limit || !solve(*limit)) break;
    }
    return std::move(front_);
  }

 private:
  /// Adds the lightest design that does so well in the second; false: there is none, or a limit.
  bool solve(std::optional<double> limit) {
    Problem asked = problem_;
    if (limit) this->limit(asked) = io::exact(*limit);
    SynthesisOptions options;
    options.should_stop = options_.should_stop;
    const SynthesisResult found = synthesise(asked, options);
    if (found.status == SynthesisStatus::kLimit) front_.is_whole = false;
    if (found.status == SynthesisStatus::kInfeasible && limit) front_.none_from = *limit;
    if (found.status != SynthesisStatus::kOptimal) return false;
    FrontPoint point{found.best->mass_kg,
                     found.bound_kg,
                     *objective_value(second_, found.best->report),
                     limit,
                     found.best->problem,
                     found.best->report};
    const auto place = std::lower_bound(
        front_.points.begin(), front_.points.end(), point,
        [&](const FrontPoint& a, const FrontPoint& b) { return gained(a.second, b.second) > 0.0; });
    front_.points.insert(place, std::move(point));
    options_.report(front_.points.size());
    return true;
  }

  /// What the second value has over the first.
  double gained(double from, double to) const {
    return is_greater_better(second_) ? to - from : from - to;
  }

  std::optional<Rational>& limit(Problem& problem) const {
    if (second_ == Objective::kReflectedInertia) return problem.floors.reflected_inertia_kg_m2;
    if (second_ == Objective::kForwardEfficiency) return problem.floors.forward_efficiency;
    if (second_ == Objective::kBackwardEfficiency) return problem.floors.backward_efficiency;
    return problem.floors.hollow_shaft_mm;
  }

  /// What nothing reaches.
  double out_of_reach() const {
    if (second_ == Objective::kReflectedInertia) return 0.0;
    return second_ == Objective::kHollowShaft ? io::nearest(problem_.rotor_inner_diameter_mm) : 1.0;
  }

  void enclose_best() {
    constexpr int kHalvings = 5;
    double beyond = out_of_reach();
    for (int i = 0; i < kHalvings && front_.is_whole; ++i) {
      const double middle = 0.5 * (front_.points.back().second + beyond);
      if (!solve(middle)) beyond = middle;
    }
  }

  std::optional<double> amid_the_widest_gap() const {
    double widest = 1e-6 * std::abs(front_.points.back().second);
    std::optional<double> middle;
    for (std::size_t i = 1; i < front_.points.size(); ++i) {
      const double from = front_.points[i - 1].second;
      const double to = front_.points[i].from.value_or(front_.points[i].second);
      if (gained(from, to) <= widest) continue;
      widest = gained(from, to);
      middle = 0.5 * (from + to);
    }
    return middle;
  }

  const Problem& problem_;
  Objective second_;
  const FrontOptions& options_;
  Front front_;
};

}  // namespace

std::optional<double> objective_value(Objective objective, const DesignReport& report) {
  switch (objective) {
    case Objective::kMass:
      return report.mass_kg;
    case Objective::kHollowShaft:
      return report.hollow_shaft_diameter_mm;
    case Objective::kForwardEfficiency:
      return report.forward_efficiency;
    case Objective::kBackwardEfficiency:
      return report.backward_efficiency;
    case Objective::kReflectedInertia:
      return report.reflected_inertia_kg_m2;
    case Objective::kPaperCost:
      break;
  }
  return std::nullopt;
}

bool is_greater_better(Objective objective) {
  return objective == Objective::kForwardEfficiency ||
         objective == Objective::kBackwardEfficiency || objective == Objective::kHollowShaft;
}

bool can_be_limited(Objective objective) {
  return is_greater_better(objective) || objective == Objective::kReflectedInertia;
}

Front design_front(const Problem& problem, Objective second, const FrontOptions& options) {
  if (problem.synthesis) return SizedFront(problem, second, options).run();
  return WholeFront(problem, second, options).run();
}

}  // namespace torquewright::gearbox
