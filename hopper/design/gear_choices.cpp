// SPDX-License-Identifier: Apache-2.0
#include "hopper/design/gear_choices.hpp"

#include <utility>

#include "actuator/motor/gear_transmission.hpp"
#include "gearbox/front/front.hpp"
#include "gearbox/search/search.hpp"
#include "gearbox/synthesis/synthesis.hpp"
#include "gearbox/topologies/topology.hpp"

namespace torquewright::hopper {
namespace {

using gearbox::DesignReport;
using gearbox::Problem;

/// Gears that the search accepts are a train: an objection would be a defect of ours.
void add(Problem problem, DesignReport report, double bound, GearsOfRatio& gears) {
  actuator::GearTransmission train = actuator::gear_transmission(problem, report.design);
  if (!train.objection.empty()) return;
  gears.choices.push_back(
      {std::move(problem), std::move(report), std::move(train.transmission), bound});
}

void add_lightest(const Problem& problem, const std::function<bool()>& should_stop,
                  GearsOfRatio& gears) {
  gearbox::SynthesisOptions options;
  options.should_stop = should_stop;
  const gearbox::SynthesisResult found = gearbox::synthesise(problem, options);
  if (found.status == gearbox::SynthesisStatus::kInfeasible) gears.search = GearSearch::kNone;
  if (found.status != gearbox::SynthesisStatus::kOptimal) return;
  gears.search = GearSearch::kProved;
  add(found.best->problem, found.best->report, found.bound_kg, gears);
}

void add_best(const Problem& problem, const std::function<bool()>& should_stop,
              GearsOfRatio& gears) {
  gearbox::DesignSearchOptions options;
  options.should_stop = should_stop;
  const gearbox::DesignSearchResult found = gearbox::optimize(problem, options);
  if (found.status == gearbox::DesignSearchStatus::kInfeasible) gears.search = GearSearch::kNone;
  if (found.status != gearbox::DesignSearchStatus::kOptimal) return;
  gears.search = GearSearch::kProved;
  const gearbox::Design& best = found.designs.front();
  add(problem, gearbox::find_topology(problem.topology)->evaluate(problem, best), *found.bound,
      gears);
}

void add_front(const Problem& problem, std::size_t points, const std::function<bool()>& should_stop,
               GearsOfRatio& gears) {
  gearbox::FrontOptions options;
  options.points = points;
  options.should_stop = should_stop;
  gearbox::Front front =
      gearbox::design_front(problem, gearbox::Objective::kForwardEfficiency, options);
  if (front.is_whole) {
    gears.search = front.points.empty() ? GearSearch::kNone : GearSearch::kProved;
  }
  for (gearbox::FrontPoint& point : front.points) {
    add(std::move(point.problem), std::move(point.report), point.first_bound, gears);
  }
}

}  // namespace

Problem at_ratio(const Problem& problem, const io::Rational& ratio) {
  Problem asked = problem;
  asked.target_ratio = sgn(problem.target_ratio) < 0 ? io::Rational(-ratio) : ratio;
  return asked;
}

GearsOfRatio gears_of_ratio(const Problem& problem, const io::Rational& ratio, std::size_t points,
                            const std::function<bool()>& should_stop) {
  GearsOfRatio gears{ratio, GearSearch::kLimit, {}};
  const Problem asked = at_ratio(problem, ratio);
  if (points > 1) {
    add_front(asked, points, should_stop, gears);
  } else if (asked.synthesis) {
    add_lightest(asked, should_stop, gears);
  } else {
    add_best(asked, should_stop, gears);
  }
  return gears;
}

}  // namespace torquewright::hopper
