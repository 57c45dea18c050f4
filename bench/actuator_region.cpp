// SPDX-License-Identifier: Apache-2.0
// The region of one actuator as a table, beside writing that table as CSV and beside the closed
// form of the simplest motor at as many speeds: what generality costs.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "actuator/effects/library.hpp"
#include "actuator/mor/mor_table_spec.hpp"

namespace {

using namespace torquewright::actuator;

/// The knee of seed 001, with the resistance assumed in specs/actuator/d151_knee.json.
Actuator knee() {
  Actuator actuator;
  actuator.motor.torque_constant_Nm_A = 0.32;
  actuator.motor.resistance_ohm = 0.28;
  actuator.drive.bus_voltage_V = 67.2;
  actuator.drive.peak_current_A = 50.0;
  actuator.transmission.ratio = 20.0;
  return actuator;
}

Actuator knee_on_battery() {
  Actuator actuator = knee();
  actuator.battery = Battery{};
  actuator.battery->series_cells = 16.0;
  actuator.battery->parallel_cells = 4.0;
  actuator.battery->cell_open_circuit = {{1.0, 4.2}};
  actuator.battery->cell_resistance_ohm = 0.015;
  return actuator;
}

Actuator knee_with_field_weakening() {
  Actuator actuator = knee();
  actuator.motor.pole_pairs = 21.0;
  actuator.motor.inductance_d_H = actuator.motor.inductance_q_H = 1e-4;
  actuator.drive.field_weakening = true;
  return actuator;
}

Actuator knee_with_all() {
  Actuator actuator = knee_with_field_weakening();
  actuator.battery = knee_on_battery().battery;
  return actuator;
}

Actuator salient_knee() {
  Actuator actuator = knee_with_field_weakening();
  actuator.motor.inductance_q_H = 2e-4;
  return actuator;
}

Actuator knee_with_everything() {
  Actuator actuator = salient_knee();
  actuator.battery = knee_on_battery().battery;
  actuator.effects.push_back(
      {find_effect("torque_constant_saturation"), {60.0, 2.0}, {}, false, "assumed"});
  actuator.effects.push_back({find_effect("inverter_dead_time"), {0.8}, {}, false, "assumed"});
  return actuator;
}

void table(benchmark::State& state, const Actuator& actuator) {
  std::size_t rows = 0;
  for (auto _ : state) {
    const MorTable result = mor_table(Region(actuator, {}));
    rows = result.rows.size();
    benchmark::DoNotOptimize(result);
  }
  state.counters["rows"] = static_cast<double>(rows);
}

void closed_form(benchmark::State& state) {
  for (auto _ : state) {
    for (int i = 0; i < 64; ++i) {
      const double speed_rad_s = 253.75 * i / 63.0;
      benchmark::DoNotOptimize(0.32 * std::min(50.0, (67.2 - 0.32 * speed_rad_s) / 0.28));
    }
  }
}

void csv(benchmark::State& state) {
  const Actuator actuator = knee();
  const MorTable result = mor_table(Region(actuator, {}));
  for (auto _ : state) {
    benchmark::DoNotOptimize(mor_table_csv({&actuator, {}, Side::kJoint}, result));
  }
}

BENCHMARK_CAPTURE(table, knee, knee());
BENCHMARK_CAPTURE(table, knee_on_battery, knee_on_battery());
BENCHMARK_CAPTURE(table, knee_with_field_weakening, knee_with_field_weakening());
BENCHMARK_CAPTURE(table, knee_with_field_weakening_on_battery, knee_with_all());
BENCHMARK_CAPTURE(table, salient_knee_with_field_weakening, salient_knee());
BENCHMARK_CAPTURE(table, knee_with_everything, knee_with_everything());
BENCHMARK(closed_form);
BENCHMARK(csv);

}  // namespace

BENCHMARK_MAIN();
