// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/bench_log/bench_draw.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

namespace torquewright::oracles {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

void draw_load(Bench& bench, Chance& chance) {
  Machine& machine = bench.nominal;
  StatedLoad& stated = bench.stated;
  const double peak = peak_torque_Nm(machine);
  if (machine.load.type == Load::Type::kPendulum) {
    stated.length_m = rounded(chance.between(0.2, 0.4));
    stated.mass_kg = rounded(peak * chance.between(0.25, 0.4) / (kGravity_m_s2 * stated.length_m));
    stated.inertia_kg_m2 = rounded(0.1 * stated.mass_kg * stated.length_m * stated.length_m);
    machine.load.inertia_kg_m2 =
        stated.inertia_kg_m2 + stated.mass_kg * stated.length_m * stated.length_m;
    machine.load.gravity_Nm = stated.mass_kg * kGravity_m_s2 * stated.length_m;
  } else if (machine.load.type == Load::Type::kFree) {
    stated.inertia_kg_m2 = rounded(peak * chance.between(0.006, 0.015));
    machine.load.inertia_kg_m2 = stated.inertia_kg_m2;
  } else if (machine.load.type == Load::Type::kLinearAxis) {
    stated.mass_kg = rounded(peak * chance.between(0.03, 0.06));
    machine.load.inertia_kg_m2 = stated.mass_kg;
  }
}

Knots drawn_shape(Chance& chance, std::size_t count, std::size_t kind, double most_Hz) {
  switch (kind % 5) {
    case 0:
      return multisine(chance, count, 0.1, most_Hz, 6);
    case 1:
      return triangle(chance, count, chance.between(5.0, 8.0));
    case 2:
      return steps(chance, count, 1.2);
    case 3:
      return chirp(count, 0.1, most_Hz);
    default:
      return multisine(chance, count, 0.07, 0.4 * most_Hz, 4);
  }
}

/// The output's speed that the rig is meant for [rad/s]; on a linear axis m/s.
double rig_speed(const Wishes& wishes, const Machine& machine, Chance& chance) {
  const double speed = chance.between(3.0, 7.0);
  return wishes.slow ? std::min(speed, 25.0 / machine.ratio) * 0.5 : speed;
}

RunPlan dynamometer_run(const Bench& bench, const Wishes& wishes, std::size_t index,
                        double speed_rad_s, Chance& chance) {
  RunPlan plan;
  const std::size_t count = knot_count(wishes.run_s);
  // Every other run has a slow part: what happens near rest is in training and held-out runs.
  const double size = index % 2 == 0 ? chance.between(0.7, 1.0) : chance.between(0.25, 0.6);
  plan.speed_rad_s = scaled(drawn_shape(chance, count, index % 2 == 0 ? 0 : 1 + index / 2, 1.4),
                            size * speed_rad_s);
  const double current = bench.nominal.peak_current_A * chance.between(0.5, 0.85);
  const double most_Hz = wishes.fast_current ? 8.0 : 2.5;
  const std::size_t kind = wishes.fast_current ? 0 : 2 * index;
  plan.current_A = scaled(drawn_shape(chance, count, kind, most_Hz), current);
  plan.start_rad = chance.between(-1.0, 1.0);
  return plan;
}

// Two lags in a row: the motion starts from rest, and edges do not only saturate the drive.
void soften(Knots& knots, double time_constant_s) {
  const double share = kTick_s / time_constant_s;
  double first = knots.front();
  double second = knots.front();
  for (double& value : knots) {
    first += share * (value - first);
    second += share * (first - second);
    value = second;
  }
}

RunPlan controlled_run(const Bench& bench, const Wishes& wishes, std::size_t index, double size,
                       Chance& chance) {
  RunPlan plan;
  const std::size_t count = knot_count(wishes.run_s);
  const double most_Hz = wishes.slow ? 0.3 : (wishes.fast_current ? 3.0 : 1.0);
  const double damp = wishes.fast_current ? 0.3 : 1.0;
  plan.position_rad =
      scaled(drawn_shape(chance, count, index % 2 == 0 ? 0 : 1 + index / 2, most_Hz),
             damp * size * chance.between(0.7, 1.0));
  soften(plan.position_rad, wishes.fast_current ? 0.04 : 0.08);
  plan.start_rad = plan.position_rad[0];
  set_controller(bench.nominal, plan);
  return plan;
}

void draw_runs(Bench& bench, const Wishes& wishes, Chance& chance) {
  const double speed = rig_speed(wishes, bench.nominal, chance);
  const bool is_linear = bench.nominal.load.type == Load::Type::kLinearAxis;
  const bool is_free = bench.nominal.load.type == Load::Type::kFree;
  const double size = is_linear ? chance.between(0.1, 0.2)
                                : (is_free ? chance.between(1.5, 3.0) : chance.between(0.9, 1.5));
  for (std::size_t r = 0; r < static_cast<std::size_t>(wishes.runs); ++r) {
    bench.runs.push_back(bench.nominal.load.type == Load::Type::kDynamometer
                             ? dynamometer_run(bench, wishes, r, speed, chance)
                             : controlled_run(bench, wishes, r, size, chance));
    bench.runs.back().name = "run_" + std::to_string(r + 1);
  }
}

}  // namespace

double rounded(double value, int digits) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*e", digits - 1, value);
  return std::strtod(text.data(), nullptr);
}

double peak_torque_Nm(const Machine& machine) {
  return machine.ratio * machine.torque_constant_Nm_A * machine.peak_current_A;
}

void set_controller(const Machine& machine, RunPlan& plan) {
  constexpr double kRate_rad_s = 18.0;
  const double inertia = machine.load.inertia_kg_m2 + machine.motor_inertia_kg_m2();
  plan.controller_Nm_rad = inertia * kRate_rad_s * kRate_rad_s;
  plan.controller_Nm_s_rad = 1.6 * inertia * kRate_rad_s;
}

void draw_machine(Bench& bench, const Wishes& wishes, Chance& chance) {
  Machine& machine = bench.nominal;
  machine.load.type = wishes.rig;
  const bool is_linear = wishes.rig == Load::Type::kLinearAxis;
  const std::array<double, 5> any{6.2, 7.5, 9.3, 12.4, 18.6};
  const std::array<double, 4> whole{6.0, 8.0, 9.0, 16.0};
  machine.ratio = wishes.integer_ratio ? chance.one_of(whole) : chance.one_of(any);
  if (is_linear) machine.ratio = rounded(kTurn / chance.between(0.005, 0.02));
  machine.peak_current_A = rounded(chance.between(15.0, 50.0), 2);
  const double peak = is_linear ? chance.scale(200.0, 900.0) : chance.scale(15.0, 80.0);
  machine.torque_constant_Nm_A = rounded(peak / (machine.ratio * machine.peak_current_A));
  const double reflected = peak * chance.between(0.0005, 0.0015) * (is_linear ? 10.0 : 1.0);
  machine.rotor_inertia_kg_m2 = rounded(reflected / (machine.ratio * machine.ratio));
  machine.resistance_ohm = rounded(chance.between(0.1, 0.5));
  machine.pole_pairs = static_cast<int>(7 * (1 + chance.index(3)));
  const double rms_A = 0.4 * machine.peak_current_A;
  const double loss_W = machine.resistance_ohm * rms_A * rms_A;
  machine.winding_J_K = rounded(loss_W * chance.between(0.5, 1.0));
  machine.case_J_K = rounded(machine.winding_J_K * 8.0);
  machine.winding_to_case_K_W = rounded(25.0 / loss_W);
  machine.case_to_ambient_K_W = rounded(35.0 / loss_W);
  const double top_rad_s = is_linear ? 1.5 : 12.0;
  machine.bus_V = rounded(1.3 * (machine.torque_constant_Nm_A * machine.ratio * top_rad_s +
                                 machine.resistance_ohm * machine.peak_current_A),
                          2);
  if (wishes.declares_friction) {
    const double level = rounded(peak_torque_Nm(machine) * chance.between(0.02, 0.05));
    const double viscous = rounded(level * chance.between(0.08, 0.2) * (is_linear ? 10.0 : 1.0));
    machine.friction.coulomb_positive_Nm = machine.friction.coulomb_negative_Nm = level;
    machine.friction.viscous_positive_Nm_s_rad = machine.friction.viscous_negative_Nm_s_rad =
        viscous;
  }
  draw_load(bench, chance);
}

void add_channels(Bench& bench, const Wishes& wishes, Chance& chance) {
  const Machine& machine = bench.nominal;
  const bool is_linear = wishes.rig == Load::Type::kLinearAxis;
  const double quality = chance.scale(0.6, 1.6);
  const double bits = chance.happens(0.5) ? 65536.0 : 16384.0;
  const double step = (is_linear ? 0.02 : kTurn) / bits;
  const double speed = is_linear ? 0.5 : 5.0;
  const bool short_names = chance.happens(0.5);
  const auto add = [&](const char* quantity, const char* column, double sigma, double resolution) {
    bench.channels.push_back({quantity, short_names ? column : quantity, sigma, resolution, 1.0});
  };
  add(is_linear ? "linear_position_m" : "output_position_rad", "q", 0.5 * step, step);
  if (!is_linear && short_names && chance.happens(0.2)) {
    bench.channels.back().column = "q_deg";
    bench.channels.back().column_scale = std::numbers::pi / 180.0;
  }
  if (wishes.velocity || chance.happens(0.5)) {
    add(is_linear ? "linear_velocity_m_s" : "output_velocity_rad_s", "qd", 0.003 * quality * speed,
        0.0);
  }
  const double peak = machine.peak_current_A;
  add("motor_current_A", "i_A", 0.004 * quality * peak, rounded(peak / 2048.0));
  if (wishes.rig == Load::Type::kDynamometer) {
    add("output_torque_Nm", "tau_Nm", 0.004 * quality * peak_torque_Nm(machine), 0.0);
  }
  if (wishes.two_positions) add("motor_position_rad", "q_motor", 2e-4, kTurn / 16384.0);
  if (wishes.voltages) {
    add("winding_voltage_V", "u_V", 0.003 * quality * machine.bus_V, 0.0);
    add("bus_voltage_V", "bus_V", 0.001 * quality * machine.bus_V, 0.0);
    add("duty", "duty", 0.0005, 0.0);
  }
  if (wishes.warm_runs || wishes.voltages || chance.happens(0.7)) {
    add("winding_temperature_K", "T_K", 0.2, 0.1);
  }
  bench.has_ignored_column = chance.happens(0.2);
  bench.one_file = chance.happens(0.7);
}

void set_temperatures(Bench& bench, const Wishes& wishes) {
  const Machine& machine = bench.nominal;
  for (std::size_t r = 0; r < bench.runs.size(); ++r) {
    const double warm = wishes.warm_runs ? std::array{0.0, 45.0, 20.0}[r % 3] : 0.0;
    bench.runs[r].winding_K = machine.reference_K + warm;
    bench.runs[r].case_K = machine.ambient_K + 0.8 * warm;
  }
}

Bench draw_bench(const Wishes& wishes, Chance& chance) {
  Bench bench;
  draw_machine(bench, wishes, chance);
  draw_runs(bench, wishes, chance);
  add_channels(bench, wishes, chance);
  set_temperatures(bench, wishes);
  bench.truth = bench.nominal;
  return bench;
}

}  // namespace torquewright::oracles
