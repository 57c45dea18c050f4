// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/bench_log/plant.hpp"

#include <algorithm>

#include "tests/oracles/bench_log/simulation.hpp"

namespace torquewright::oracles {
namespace {

constexpr int kRigidSubsteps = 10;    // 0.1 ms
constexpr int kTwoMassSubsteps = 20;  // 0.05 ms
constexpr int kImposedSubsteps = 5;   // Where a lag or presliding has a state.

int chosen_substeps(const Machine& machine) {
  if (machine.has_two_positions()) return kTwoMassSubsteps;
  if (machine.load.type != Load::Type::kDynamometer) return kRigidSubsteps;
  const bool has_state = machine.lag_s > 0.0 || machine.friction.presliding_Nm_rad < kInfinity;
  return has_state ? kImposedSubsteps : 1;
}

}  // namespace

std::size_t RunPlan::knot_count() const {
  return std::max({speed_rad_s.size(), position_rad.size(), current_A.size(), voltage_V.size()});
}

Trace simulate(const Machine& machine, const RunPlan& plan, int substeps, EnergyAccount* account) {
  if (substeps == 0) substeps = chosen_substeps(machine);
  Trace trace;
  const std::size_t count = plan.knot_count();
  for (auto* column :
       {&trace.position_rad, &trace.speed_rad_s, &trace.acceleration_rad_s2,
        &trace.motor_position_rad, &trace.motor_speed_rad_s, &trace.current_A, &trace.torque_Nm,
        &trace.voltage_V, &trace.bus_V, &trace.winding_K, &trace.case_K}) {
    column->reserve(count);
  }
  Simulation simulation(machine, plan);
  simulation.record(trace);
  for (std::size_t knot = 0; knot + 1 < count; ++knot) {
    simulation.aim(knot + 1);
    simulation.tick(knot, substeps);
    simulation.record(trace);
  }
  if (account != nullptr) *account = simulation.account();
  return trace;
}

}  // namespace torquewright::oracles
