// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/bench_log/dial.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

namespace torquewright::oracles {
namespace {

using Names = std::set<std::string, std::less<>>;

const Names kOverDeclared{"asymmetric_friction", "stribeck_friction", "presliding_friction",
                          "position_dependent_friction", "friction_temperature"};
const Names kOverTemperature{"torque_constant_temperature", "friction_temperature",
                             "winding_resistance_temperature"};
const Names kTwoPositions{"backlash", "torsional_compliance"};
const Names kElectrical{"voltage_sag", "winding_resistance_temperature", "inverter_dead_time"};
// Told by a torque sensor only, or best.
const Names kOnDynamometer{"torque_offset",
                           "current_offset",
                           "reflected_inertia",
                           "torque_lag",
                           "torque_constant_error",
                           "position_dependent_friction",
                           "torque_constant_temperature",
                           "torque_constant_saturation",
                           "friction_temperature",
                           "cogging_torque",
                           "gear_ripple",
                           "asymmetric_friction"};

Load::Type rig_for(const std::string& effect, Chance& chance) {
  using Type = Load::Type;
  const bool other = chance.happens(0.35);
  if (effect == "gravity_imbalance" || effect == "load_inertia_error") return Type::kFree;
  if (effect == "load_mass_error") return other ? Type::kLinearAxis : Type::kPendulum;
  if (kOnDynamometer.contains(effect) || kElectrical.contains(effect) ||
      kTwoPositions.contains(effect)) {
    return Type::kDynamometer;
  }
  if (!other) return Type::kDynamometer;
  const std::array<Type, 3> any{Type::kPendulum, Type::kPendulum, Type::kLinearAxis};
  return chance.one_of(any);
}

std::vector<std::string> same_as(const TrueEffect& effect, const Bench& bench) {
  const Load::Type rig = bench.nominal.load.type;
  const std::string& name = effect.effect;
  const bool has_sensor = rig == Load::Type::kDynamometer;
  if (name == "torque_offset" || name == "current_offset") {
    const std::string other = name == "torque_offset" ? "current_offset" : "torque_offset";
    return {name, other, "asymmetric_friction"};
  }
  if (name == "load_inertia_error") {
    if (rig == Load::Type::kFree) return {name, "reflected_inertia", "torque_constant_error"};
    return {name, "reflected_inertia"};
  }
  if (name == "load_mass_error" && rig == Load::Type::kLinearAxis) {
    return {name, "reflected_inertia", "torque_constant_error"};
  }
  if (name == "load_mass_error") return {name, "torque_constant_error"};
  if (name == "gravity_imbalance") return {name, "gear_ripple"};
  const bool is_whole = bench.nominal.ratio == std::floor(bench.nominal.ratio);
  if (name == "cogging_torque" && is_whole && has_sensor) return {name, "gear_ripple"};
  return {name};
}

}  // namespace

Wishes wishes_for(const std::string& effect, Chance& chance) {
  Wishes wishes;
  wishes.rig = rig_for(effect, chance);
  wishes.declares_friction =
      kOverDeclared.contains(effect) ||
      (effect != "coulomb_friction" && effect != "viscous_friction" && chance.happens(0.3));
  wishes.warm_runs = kOverTemperature.contains(effect);
  wishes.slow = effect == "cogging_torque" || effect == "gear_ripple";
  wishes.fast_current = effect == "torque_lag" || effect == "channel_delay";
  wishes.two_positions = kTwoPositions.contains(effect);
  wishes.voltages = kElectrical.contains(effect);
  wishes.velocity = effect == "velocity_mismatch";
  return wishes;
}

int least_order(const Bench& bench) {
  double widest_rad = 0.0;
  const std::size_t held_out = bench.runs.size() > 2 ? 2 : 0;
  for (std::size_t r = 0; r + held_out < bench.runs.size(); ++r) {
    double angle_rad = 0.0, least_rad = 0.0, most_rad = 0.0;
    for (const double speed_rad_s : bench.runs[r].speed_rad_s) {
      angle_rad += speed_rad_s * kTick_s;
      least_rad = std::min(least_rad, angle_rad);
      most_rad = std::max(most_rad, angle_rad);
    }
    widest_rad = std::max(widest_rad, most_rad - least_rad);
  }
  if (!(widest_rad > 0.0)) return 1;
  return static_cast<int>(std::ceil(1.1 * 2.0 * std::numbers::pi / widest_rad));
}

Dial dial_for(const std::string& effect, const Bench& bench, Chance& chance) {
  for (const auto& kind : {friction_dial, motor_dial, gear_dial, log_dial}) {
    Dial dial = kind(effect, bench, chance);
    if (!dial.set) continue;
    dial.effect.effect = effect;
    if (dial.effect.family.empty()) dial.effect.family = "actuator";
    dial.effect.same_as = same_as(dial.effect, bench);
    return dial;
  }
  throw std::invalid_argument("no effect " + effect);
}

}  // namespace torquewright::oracles
