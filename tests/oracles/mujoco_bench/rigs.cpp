// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/mujoco_bench/rigs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/oracles/mujoco_bench/plant.hpp"
#include "tests/oracles/mujoco_bench/runs.hpp"

namespace torquewright::oracles::mujoco_bench {
namespace {

constexpr double kTurn_rad = 2 * std::numbers::pi;

double draw_ratio(Draws& draws) {
  const std::vector<double> whole = {1, 5, 6, 9, 10, 16, 20, 36, 50, 80, 100, 120, 160};
  if (draws.chance(0.5)) return draws.one_of(whole);
  return std::round(1e4 * draws.log_uniform(1.5, 120)) / 1e4;
}

/// Torque, speed, and acceleration are drawn; constants follow.
void draw_motor(Situation& it, Draws& draws, const Demand& demand) {
  Motor& motor = it.bench.world.motor;
  const double acceleration =
      demand.gentle ? draws.log_uniform(150, 500) : draws.log_uniform(150, 2500);
  const double peak = draws.log_uniform(0.1, 1000);
  do motor.ratio = draw_ratio(draws);
  while (peak / motor.ratio < 0.01 || peak / motor.ratio > 100);
  motor.peak_current_A =
      std::clamp(draws.log_uniform(0.5, 2) * 15 * std::cbrt(peak / motor.ratio), 2.0, 120.0);
  motor.torque_constant_Nm_A = peak / motor.ratio / motor.peak_current_A;
  motor.rotor_inertia_kg_m2 = peak / acceleration / motor.ratio / motor.ratio;
  it.top_speed_rad_s = std::min({draws.log_uniform(2, 40), 1200 / motor.ratio, acceleration / 30});
  const double back_emf = motor.torque_constant_Nm_A * motor.ratio * it.top_speed_rad_s;
  motor.resistance_ohm = draws.uniform(0.3, 1) * (back_emf + 6) / motor.peak_current_A;
  motor.bus_voltage_V = 1.3 * (back_emf + motor.resistance_ohm * motor.peak_current_A);
  motor.pole_pairs = static_cast<int>(4 + draws.below(18));
  if (draws.chance(0.3) && !demand.gentle) {
    motor.forward_efficiency = draws.uniform(0.75, 0.98);
    motor.backward_efficiency = motor.forward_efficiency - draws.uniform(0, 0.08);
  }
}

void draw_load(Situation& it, Draws& draws, const Demand& demand) {
  Load& load = it.bench.world.load;
  load.type = draws.one_of(demand.loads);
  const double armature = it.bench.world.motor.armature_kg_m2();
  // A machine that friction and ripple of the actuator do not slow.
  it.bench.inertia_kg_m2 = armature * draws.uniform(15, 40);
  it.bench.bandwidth_hz = draws.uniform(1.5, 4);
  if (load.type == "free") load.inertia_kg_m2 = armature * draws.log_uniform(0.5, 8);
  if (load.type == "linear_axis") load.mass_kg = armature * draws.log_uniform(0.5, 8);
  if (load.type != "pendulum") return;
  load.length_m = draws.log_uniform(0.08, 0.8);
  load.mass_kg = draws.uniform(0.25, 0.55) * it.peak_torque_Nm() / kGravity_m_s2 / load.length_m;
  load.inertia_kg_m2 = load.mass_kg * load.length_m * load.length_m * draws.uniform(0.02, 0.3);
}

/// The rotor's armature is to be of the load's size.
void fit_rotor_to_pendulum(Situation& it, Draws& draws) {
  const Load& load = it.bench.world.load;
  Motor& motor = it.bench.world.motor;
  const double whole = load.inertia_kg_m2 + load.mass_kg * load.length_m * load.length_m;
  motor.rotor_inertia_kg_m2 = draws.log_uniform(0.05, 1) * whole / motor.ratio / motor.ratio;
  it.top_speed_rad_s = std::min(it.top_speed_rad_s, 12.0);
}

void add(LogFormat& format, const std::string& quantity, double noise, double quantum) {
  format.quantities.push_back(quantity);
  format.grains[quantity] = {noise, quantum};
}

void add_motion(Situation& it, Draws& draws, const Demand& demand) {
  LogFormat& format = it.format;
  const bool slides = it.bench.world.load.type == "linear_axis";
  const double ratio = it.bench.world.motor.ratio;
  const bool motor = demand.two_encoders || (!slides && draws.chance(0.35));
  const bool output = slides || demand.two_encoders || !motor || draws.chance(0.5);
  const double fine = kTurn_rad / std::pow(2, 15 + static_cast<double>(draws.below(5)));
  if (output) add(format, slides ? "linear_position_m" : "output_position_rad", 0.3 * fine, fine);
  const double coarse = kTurn_rad / std::pow(2, 12 + static_cast<double>(draws.below(4)));
  if (motor) add(format, "motor_position_rad", 0.3 * coarse, coarse);
  if (!demand.velocity && !draws.chance(0.4)) return;
  const double noise = it.top_speed_rad_s * draws.log_uniform(5e-4, 5e-3);
  if (output)
    add(format, slides ? "linear_velocity_m_s" : "output_velocity_rad_s", noise, noise / 4);
  else
    add(format, "motor_velocity_rad_s", noise * ratio, noise * ratio / 4);
}

/// Noise that has this share of the range within the band.
Grain white(double range, double share, double row_s) {
  const double whole = range * share * std::sqrt(0.5 / row_s / 8);
  return {whole, whole / 5};
}

void add_electric(Situation& it, Draws& draws, const Demand& demand, double share) {
  LogFormat& format = it.format;
  const Motor& motor = it.bench.world.motor;
  const bool volts = demand.drive == "duty" || (demand.drive == "any" && draws.chance(0.15));
  const bool amperes = !volts || draws.chance(0.5);
  it.bench.voltage_driven = !amperes;
  if (amperes) {
    const Grain grain = white(motor.peak_current_A, 0.4 * share, format.row_s());
    add(format, "motor_current_A", grain.noise, grain.quantum);
  }
  if (!volts) return;
  const Grain bus = white(motor.bus_voltage_V, 0.5 * share, format.row_s());
  if (demand.drive == "any" && draws.chance(0.4)) {
    add(format, "winding_voltage_V", bus.noise, bus.quantum);
    return;
  }
  add(format, "duty", 0, 1e-5);
  add(format, "bus_voltage_V", bus.noise, bus.quantum);
}

void add_channels(Situation& it, Draws& draws, const Demand& demand) {
  it.format.records_per_row = draws.one_of(std::vector<int>{1, 2, 2, 4});
  const double share = draws.log_uniform(3e-4, 4e-3);
  add_motion(it, draws, demand);
  add_electric(it, draws, demand, share);
  if (it.bench.world.load.type == "dynamometer") {
    const Grain grain = white(it.peak_torque_Nm(), share, it.format.row_s());
    add(it.format, "output_torque_Nm", grain.noise, grain.quantum);
  }
  if (demand.temperature || draws.chance(0.15)) {
    it.bench.warms = true;
    add(it.format, "winding_temperature_K", 0.05, 0.1);
  }
}

/// Some 15 K in a minute at half the peak current.
void draw_heat(Situation& it, Draws& draws) {
  const double rms = 0.4 * it.bench.world.motor.peak_current_A;
  it.bench.heating_K_s_A2 = draws.uniform(0.1, 0.4) / rms / rms;
  it.bench.cooling_s = draws.log_uniform(60, 400);
}

}  // namespace

Situation draw_rig(Draws& draws, const Demand& demand) {
  Situation it;
  draw_motor(it, draws, demand);
  draw_load(it, draws, demand);
  if (it.bench.world.load.type == "pendulum") fit_rotor_to_pendulum(it, draws);
  add_channels(it, draws, demand);
  draw_heat(it, draws);
  draw_runs(it, draws, demand);
  it.stated = it.bench.world;
  return it;
}

}  // namespace torquewright::oracles::mujoco_bench
