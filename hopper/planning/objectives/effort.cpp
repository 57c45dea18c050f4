// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/objectives/costs.hpp"
#include "hopper/planning/objectives/every_objective.hpp"
#include "hopper/planning/plane/simpson.hpp"
#include "hopper/planning/plane/variable_numbers.hpp"

namespace torquewright::hopper {
namespace {

/// An instant's part of the integral. Variables: drives (d), the phase's duration.
struct EffortLaw {
  std::vector<double> most_Nm;
  double factor;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    T sum(0.0);
    for (std::size_t i = 0; i < most_Nm.size(); ++i) {
      const T share = x[static_cast<Eigen::Index>(i)] * (1.0 / most_Nm[i]);
      sum += share * share;
    }
    rows[0] = factor * x[x.size() - 1] * sum;
  }
};

Costs costs(const PlanModel& model, const FlipProgram& program, double factor) {
  std::vector<double> most_Nm;
  for (const DriveRegion& region : *model.regions) most_Nm.push_back(region.greatest_torque_Nm());
  Costs out;
  for (std::size_t phase = 0; phase < program.phases.size(); ++phase) {
    const PhaseVariables& variables = program.phases[phase];
    const std::vector<double> shares = simpson_shares(program.mesh[phase].knots);
    for (std::size_t point = 0; point < shares.size(); ++point) {
      out.push_back(jet_cost("effort",
                             in_order({numbers_from(variables.points[point].drives,
                                                    static_cast<Eigen::Index>(most_Nm.size())),
                                       {variables.duration}}),
                             EffortLaw{most_Nm, factor * shares[point]}));
    }
  }
  return out;
}

/// Its value is the cost: 0.055 s in the hopper's flip, from which kTypicalCost is.
void add(const PlanModel& model, const PlanOptions&, double weight, FlipProgram& program) {
  add_costs(costs(model, program, weight), program);
}

double value(const PlanModel& model, const PlanOptions&, const FlipProgram& program,
             const std::vector<double>& values) {
  return sum_of(costs(model, program, 1.0), values);
}

}  // namespace

const Objective objectives::effort{
    "effort",
    "least integral of the squared torques of all drives, each over the greatest that its region "
    "gives: the seconds in which one drive at its limit would heat as much",
    "s", add, value};

}  // namespace torquewright::hopper
