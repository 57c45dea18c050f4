// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/objectives/costs.hpp"
#include "hopper/planning/objectives/every_objective.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kTypical_s = 2.5;  // that the hopper's flip of least effort takes

struct TimeLaw {
  double factor;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    rows[0] = factor * x[0];
  }
};

Costs costs(const FlipProgram& program, double factor) {
  Costs out;
  for (const PhaseVariables& phase : program.phases) {
    out.push_back(jet_cost("time", {phase.duration}, TimeLaw{factor}));
  }
  return out;
}

void add(const PlanModel&, const PlanOptions&, double weight, FlipProgram& program) {
  add_costs(costs(program, weight * kTypicalCost / kTypical_s), program);
}

double value(const PlanModel&, const PlanOptions&, const FlipProgram& program,
             const std::vector<double>& values) {
  return sum_of(costs(program, 1.0), values);
}

}  // namespace

const Objective objectives::time{"time", "least time from standing to standing", "s", add, value};

}  // namespace torquewright::hopper
