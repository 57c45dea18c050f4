// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/objectives/costs.hpp"
#include "hopper/planning/objectives/every_objective.hpp"
#include "hopper/planning/objectives/flight_phase.hpp"
#include "hopper/planning/plane/sagittal_momentum.hpp"
#include "hopper/planning/plane/variable_numbers.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kTypical_Nm_s = 6.0;  // of the hopper's flip

/// Of the instant, constant while it flies. Variables: the base's pitch and the joints (m - 2),
/// their rates.
struct MomentumLaw {
  const SagittalRobot* robot;
  double factor;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    const Eigen::Index half = x.size() / 2;
    rows[0] = factor * sagittal_momentum<T>(*robot, x.head(half), x.tail(half)).angular_Nm_s;
  }
};

Costs costs(const PlanModel& model, const FlipProgram& program, double factor) {
  const PointVariables& take_off = longest_flight(program, "cam").points.front();
  const Eigen::Index turning = model.plane.moving_count() - 2;
  Costs out;
  out.push_back(jet_cost("cam",
                         in_order({numbers_from(take_off.position + 2, turning),
                                   numbers_from(take_off.velocity + 2, turning)}),
                         MomentumLaw{&model.plane, factor}));
  return out;
}

void add(const PlanModel& model, const PlanOptions&, double weight, FlipProgram& program) {
  add_costs(costs(model, program, -weight * kTypicalCost / kTypical_Nm_s), program);
}

double value(const PlanModel& model, const PlanOptions&, const FlipProgram& program,
             const std::vector<double>& values) {
  return sum_of(costs(model, program, 1.0), values);
}

}  // namespace

const Objective objectives::cam{
    "cam", "greatest angular momentum about the centre of mass forwards, of the longest flight",
    "Nm s", add, value};

}  // namespace torquewright::hopper
