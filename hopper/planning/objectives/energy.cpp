// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/objectives/costs.hpp"
#include "hopper/planning/objectives/drives_at.hpp"
#include "hopper/planning/objectives/every_objective.hpp"
#include "hopper/planning/plane/simpson.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kTypical_J = 100.0;  // of the hopper's flip of least effort

/// An instant's part of the integral. Variables: DrivesAt, the phase's duration.
struct EnergyLaw {
  DrivesAt drives;
  double factor;

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    const DriveStateOf<T> state = drives.state<T>(x);
    T power_W(0.0);
    for (Eigen::Index i = 0; i < drives.drives(); ++i) {
      const auto drive = static_cast<std::size_t>(i);
      power_W +=
          drawn_behind_line_W<T>(state.bus_V[i], state.lines_ohm[drive],
                                 drives.regions()[drive].bus_power_W<T>(
                                     state.torque_Nm[i], state.speed_rad_s[i], state.bus_V[i]));
    }
    rows[0] = factor * x[x.size() - 1] * power_W;
  }
};

Costs costs(const PlanModel& model, const FlipProgram& program, double factor) {
  const DrivesAt drives(model);
  Costs out;
  for (std::size_t phase = 0; phase < program.phases.size(); ++phase) {
    const PhaseVariables& variables = program.phases[phase];
    const std::vector<double> shares = simpson_shares(program.mesh[phase].knots);
    for (std::size_t point = 0; point < shares.size(); ++point) {
      out.push_back(jet_cost(
          "energy", in_order({drives.numbers(variables.points[point]), {variables.duration}}),
          EnergyLaw{drives, factor * shares[point]}));
    }
  }
  return out;
}

void add(const PlanModel& model, const PlanOptions&, double weight, FlipProgram& program) {
  add_costs(costs(model, program, weight * kTypicalCost / kTypical_J), program);
}

double value(const PlanModel& model, const PlanOptions&, const FlipProgram& program,
             const std::vector<double>& values) {
  return sum_of(costs(model, program, 1.0), values);
}

}  // namespace

const Objective objectives::energy{
    "energy", "least energy that all drives take from their buses, less what they give back", "J",
    add, value};

}  // namespace torquewright::hopper
