// SPDX-License-Identifier: Apache-2.0
#include "hopper/flip/jet_rows.hpp"
#include "hopper/flip/objectives/every_objective.hpp"

namespace torquewright::hopper {
namespace {

struct EffortLaw {
  double share, most, smooth, chatter;
  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    const T a = x[0] * (1 / most), b = x[1] * (1 / most), c = x[2] * (1 / most);
    const T bend = a - b - b + c;
    rows[0] = x[3] * (share / 6.0) * (a * a + 4.0 * (b * b) + c * c) +
              (2.0 * smooth / share) * ((b - a) * (b - a) + (c - b) * (c - b)) / x[3] +
              chatter * (bend * bend);
  }
};

}  // namespace

Costs objective_rows(const PlanModel& model, const PlanOptions&, FlipProgram& program) {
  Costs costs;
  const std::size_t drives = model.plane.drive_count();
  for (std::size_t p = 0; p < program.phases.size(); ++p) {
    const PhaseVariables& phase = program.phases[p];
    const auto& knots = program.mesh[p].knots;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      for (std::size_t d = 0; d < drives; ++d) {
        const int at = static_cast<int>(d);
        costs.push_back(jet_rows("effort",
                                 {phase.points[2 * i].drives + at, phase.points[2 * i + 1].drives + at,
                                  phase.points[2 * i + 2].drives + at, phase.duration},
                                 {{}}, {1.0},
                                 EffortLaw{knots[i + 1] - knots[i],
                                           (*model.regions)[d].greatest_torque_Nm(), 1e-5, 1e-3}));
      }
    }
  }
  const double ac = 1e-3;
  for (std::size_t p = 0; p < program.phases.size(); ++p) {
    const PhaseVariables& phase = program.phases[p];
    const auto& knots = program.mesh[p].knots;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      for (std::size_t j = 3; j < model.plane.moving.size(); ++j) {
        const int at = static_cast<int>(j);
        costs.push_back(jet_rows("smooth",
                                 {phase.points[2 * i].acceleration + at, phase.points[2 * i + 1].acceleration + at,
                                  phase.points[2 * i + 2].acceleration + at, phase.duration},
                                 {{}}, {1.0},
                                 EffortLaw{ac * (knots[i + 1] - knots[i]), 100.0, 0.0, 0.0}));
      }
    }
  }
  return costs;
}

}  // namespace torquewright::hopper
