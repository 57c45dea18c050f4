// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/loop_bench/sensing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/oracles/loop_bench/draws.hpp"

namespace torquewright::oracles::loop {
namespace {

using std::numbers::pi;

constexpr double kDutyStep = 1e-4;

/// The winding's current behind the sensor's filter, at every step.
std::vector<double> filtered(const std::vector<State>& states, std::size_t joint, double cut_Hz) {
  const double part = 1.0 - std::exp(-2.0 * pi * cut_Hz * kStep_s);
  std::vector<double> out;
  out.reserve(states.size());
  double now = states.front().current_A[joint];
  for (const State& state : states) out.push_back(now += part * (state.current_A[joint] - now));
  return out;
}

double winding_V(const Drive& drive, const State& state, std::size_t joint) {
  const double i = state.current_A[joint];
  double volts =
      drive.resistance_ohm * i + drive.torque_per_current_Nm_A() * state.speed_rad_s[joint];
  if (const Law* dead = law_named(drive.hidden, "inverter_dead_time"))
    volts += dead->at("voltage_V") * static_cast<double>((i > 0.0) - (i < 0.0));
  return volts;
}

/// duty Vbus = V and Vbus = V0 - R duty i: a quadratic equation of the bus' voltage.
double bus_under_load_V(const Drive& drive, double volts, double current_A) {
  const Law* sag = law_named(drive.hidden, "voltage_sag");
  if (sag == nullptr) return drive.bus_V;
  const double drop = sag->at("resistance_ohm") * volts * current_A;
  return 0.5 * (drive.bus_V + std::sqrt(std::max(drive.bus_V * drive.bus_V - 4.0 * drop, 0.0)));
}

}  // namespace

Record sensed(const Rig& rig, const Sensing& sensing, const std::vector<State>& states,
              std::uint64_t run) {
  Draws draws(sensing.seed * 1000 + run);
  const auto each = static_cast<std::size_t>(std::llround(1.0 / (sensing.rate_Hz * kStep_s)));
  const auto late = static_cast<std::size_t>(std::llround(sensing.current_delay_s / kStep_s));
  const double count_rad = 2.0 * pi / sensing.counts_per_turn;
  std::vector<std::vector<double>> currents;
  for (std::size_t j = 0; j < rig.joints(); ++j)
    currents.push_back(filtered(states, j, sensing.current_filter_Hz));
  Record record;
  for (std::size_t k = each; k < states.size(); k += each) {
    Row row{static_cast<double>(k - each) * kStep_s, {}};
    for (std::size_t j = 0; j < rig.joints(); ++j) {
      Sample sample;
      const double counts = std::round(states[k].position_rad[j] / count_rad);
      const double before = std::round(states[k - each].position_rad[j] / count_rad);
      sample.position_rad = counts * count_rad;
      sample.velocity_rad_s = (counts - before) * count_rad * sensing.rate_Hz;
      sample.current_A = currents[j][k >= late ? k - late : 0] + sensing.current_offset_A +
                         sensing.current_noise_A * draws.normal();
      const double volts = winding_V(rig.drives[j], states[k], j);
      const double bus = bus_under_load_V(rig.drives[j], volts, states[k].current_A[j]);
      sample.duty = std::round(volts / bus / kDutyStep) * kDutyStep;  // set, not measured
      sample.bus_V = bus + sensing.voltage_noise_V * draws.normal();
      row.joints.push_back(sample);
    }
    record.push_back(row);
  }
  return record;
}

}  // namespace torquewright::oracles::loop
