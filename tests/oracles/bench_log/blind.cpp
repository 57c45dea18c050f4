// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <stdexcept>

#include "tests/oracles/bench_log/draw.hpp"

namespace torquewright::oracles {
namespace {

constexpr std::array<const char*, 6> kSituations{
    "nothing",    "backlash_output_encoder", "backlash_motor_encoder", "breakaway",
    "standstill", "backlash_and_friction"};

/// Without the controller: current follows slow triangles, the pendulum creeps, sticks and slips.
void creep(Bench& bench, Chance& chance) {
  const Machine& machine = bench.nominal;
  const double per_ampere = machine.ratio * machine.torque_constant_Nm_A;
  for (RunPlan& plan : bench.runs) {
    const std::size_t count = plan.knot_count();
    plan.position_rad.clear();
    plan.current_A = scaled(triangle(chance, count, chance.between(4.0, 7.0)),
                            chance.between(0.6, 0.9) * machine.load.gravity_Nm / per_ampere);
    plan.start_rad = 0.0;
  }
}

void set_coulomb(Machine& machine, double level_Nm) {
  machine.friction.coulomb_positive_Nm = machine.friction.coulomb_negative_Nm = level_Nm;
}

TrueEffect set_gap(Bench& bench, Chance& chance) {
  bench.truth.gap_rad = chance.between(0.012, 0.035);
  TrueEffect effect;
  effect.effect = "backlash";
  effect.family = "actuator";
  effect.parameters = {{"gap_rad", bench.truth.gap_rad}};
  return effect;
}

TrueEffect set_breakaway(Bench& bench, Chance& chance) {
  Friction& friction = bench.truth.friction;
  friction.breakaway_excess_Nm = friction.coulomb_positive_Nm * chance.between(0.5, 1.0);
  friction.stribeck_velocity_rad_s = chance.between(0.05, 0.2);
  TrueEffect effect;
  effect.effect = "stribeck_friction";
  effect.family = "actuator";
  effect.parameters = {
      {"coulomb_Nm", friction.coulomb_positive_Nm},
      {"breakaway_Nm", friction.coulomb_positive_Nm + friction.breakaway_excess_Nm},
      {"stribeck_velocity_rad_s", friction.stribeck_velocity_rad_s}};
  return effect;
}

TrueEffect undeclare_coulomb(Bench& bench) {
  set_coulomb(bench.nominal, 0.0);
  TrueEffect effect;
  effect.effect = "coulomb_friction";
  effect.family = "actuator";
  effect.parameters = {{"coulomb_Nm", bench.truth.friction.coulomb_positive_Nm}};
  return effect;
}

}  // namespace

Scenario draw_blind(const std::string& situation, std::uint64_t seed) {
  std::size_t kind = 0;
  while (kind < kSituations.size() && situation != kSituations[kind]) ++kind;
  if (kind == kSituations.size()) throw std::invalid_argument("no such situation: " + situation);
  Chance chance(seed * 8 + 6);
  Wishes wishes;
  wishes.rig = Load::Type::kPendulum;
  wishes.declares_friction = true;
  wishes.runs = 5;
  wishes.run_s = 10.0;
  Bench bench = draw_bench(wishes, chance);
  const bool creeps = kind == 3 || kind == 4 || (kind == 0 && chance.happens(0.5));
  if (creeps) creep(bench, chance);
  if (creeps) {
    // Friction that holds the pendulum for a part of every period.
    const double level = rounded(bench.nominal.load.gravity_Nm * chance.between(0.1, 0.2));
    set_coulomb(bench.nominal, level);
    set_coulomb(bench.truth, level);
  }
  Truth truth;
  truth.log_class = LogClass::kOne;
  truth.situation = situation;
  if (kind == 1 || kind == 2) truth.effects = {set_gap(bench, chance)};
  if (kind == 3) truth.effects = {set_breakaway(bench, chance)};
  if (kind == 4) truth.effects = {undeclare_coulomb(bench)};
  if (kind == 5) truth.effects = {undeclare_coulomb(bench), set_gap(bench, chance)};
  if (kind == 2) {
    // Its encoder sits on the motor: 14 bits of a turn.
    for (Channel& channel : bench.channels) {
      if (channel.quantity != "output_position_rad") continue;
      channel = {"motor_position_rad", "q_motor", 2e-4, 6.283185307179586 / 16384.0, 1.0};
    }
    std::erase_if(bench.channels, [](const Channel& channel) {
      return channel.quantity == "output_velocity_rad_s";
    });
  }
  return make_scenario(bench, std::move(truth), seed, chance);
}

}  // namespace torquewright::oracles
