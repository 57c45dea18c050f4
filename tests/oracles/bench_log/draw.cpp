// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/bench_log/draw.hpp"

#include <array>
#include <stdexcept>
#include <utility>

namespace torquewright::oracles {
namespace {

/// Seeds of different classes draw different benches.
Chance chance_for(LogClass log_class, std::uint64_t seed) {
  return Chance(seed * 8 + static_cast<std::uint64_t>(log_class));
}

Scenario with_nothing(std::uint64_t seed) {
  Chance chance = chance_for(LogClass::kNone, seed);
  using Type = Load::Type;
  const std::array<Type, 5> rigs{Type::kDynamometer, Type::kDynamometer, Type::kPendulum,
                                 Type::kFree, Type::kLinearAxis};
  Wishes wishes;
  wishes.rig = rigs[seed % rigs.size()];
  wishes.declares_friction = chance.happens(0.5);
  wishes.warm_runs = chance.happens(0.3);
  wishes.voltages = wishes.rig == Type::kDynamometer && chance.happens(0.3);
  const Bench bench = draw_bench(wishes, chance);
  return make_scenario(bench, {}, seed, chance);
}

Scenario with_one(const std::string& name, LogClass log_class, std::uint64_t seed) {
  Chance chance = chance_for(log_class, seed);
  Wishes wishes = wishes_for(name, chance);
  if (log_class == LogClass::kShort) {
    wishes.runs = 2;
    wishes.run_s = 0.1 * static_cast<double>(50 + chance.index(31));
  }
  Bench bench = draw_bench(wishes, chance);
  Dial dial = dial_for(name, bench, chance);
  const double strength = tune(bench, dial, chance.scale(kLeastMultiple, kMostMultiple));
  dial.set(bench, dial.effect, strength);
  Truth truth;
  truth.log_class = log_class;
  truth.effects = {dial.effect};
  return make_scenario(bench, std::move(truth), seed, chance);
}

using Pair = std::pair<const char*, const char*>;
// Told apart by a dynamometer's mixed runs (four quadrants, slow and fast).
constexpr std::array<Pair, 20> kPairs{{
    {"coulomb_friction", "viscous_friction"},
    {"coulomb_friction", "torque_constant_saturation"},
    {"viscous_friction", "torque_constant_error"},
    {"coulomb_friction", "load_dependent_friction"},
    {"quadratic_drag", "coulomb_friction"},
    {"torque_constant_saturation", "viscous_friction"},
    {"torque_constant_temperature", "coulomb_friction"},
    {"channel_delay", "coulomb_friction"},
    {"torque_offset", "viscous_friction"},
    {"gear_ripple", "coulomb_friction"},
    {"cogging_torque", "viscous_friction"},
    {"reflected_inertia", "coulomb_friction"},
    {"load_dependent_friction", "viscous_friction"},
    {"stribeck_friction", "torque_constant_error"},
    {"velocity_mismatch", "coulomb_friction"},
    {"inverter_dead_time", "coulomb_friction"},
    {"voltage_sag", "viscous_friction"},
    {"position_dependent_friction", "torque_constant_saturation"},
    {"current_offset", "torque_constant_error"},
    {"friction_temperature", "torque_constant_saturation"},
}};

Wishes together(Wishes a, const Wishes& b) {
  a.rig = Load::Type::kDynamometer;
  a.declares_friction = a.declares_friction || b.declares_friction;
  a.warm_runs = a.warm_runs || b.warm_runs;
  a.slow = a.slow || b.slow;
  a.fast_current = a.fast_current || b.fast_current;
  a.two_positions = a.two_positions || b.two_positions;
  a.voltages = a.voltages || b.voltages;
  a.velocity = a.velocity || b.velocity;
  return a;
}

Scenario with_two(std::uint64_t seed) {
  Chance chance = chance_for(LogClass::kTwo, seed);
  const auto& [first, second] = kPairs[seed % kPairs.size()];
  const Wishes wishes = together(wishes_for(first, chance), wishes_for(second, chance));
  Bench bench = draw_bench(wishes, chance);
  std::array<Dial, 2> dials{dial_for(first, bench, chance), dial_for(second, bench, chance)};
  std::array<double, 2> strengths{};
  const std::array<double, 2> multiples{chance.scale(kLeastMultiple, kMostMultiple),
                                        chance.scale(kLeastMultiple, kMostMultiple)};
  // Twice: the second dial may have turned the noise that the first was tuned to.
  for (const std::size_t d : {0U, 1U, 0U}) {
    strengths[d] = dials[d].start = tune(bench, dials[d], multiples[d]);
  }
  Truth truth;
  truth.log_class = LogClass::kTwo;
  for (std::size_t d = 0; d < 2; ++d) {
    dials[d].set(bench, dials[d].effect, strengths[d]);
    truth.effects.push_back(dials[d].effect);
  }
  return make_scenario(bench, std::move(truth), seed, chance);
}

}  // namespace

const std::vector<std::string>& drawn_effects() {
  static const std::vector<std::string> kNames{"viscous_friction",
                                               "coulomb_friction",
                                               "stribeck_friction",
                                               "asymmetric_friction",
                                               "quadratic_drag",
                                               "load_dependent_friction",
                                               "presliding_friction",
                                               "torque_constant_saturation",
                                               "torque_constant_temperature",
                                               "friction_temperature",
                                               "cogging_torque",
                                               "gear_ripple",
                                               "position_dependent_friction",
                                               "backlash",
                                               "torsional_compliance",
                                               "reflected_inertia",
                                               "torque_lag",
                                               "voltage_sag",
                                               "winding_resistance_temperature",
                                               "inverter_dead_time",
                                               "torque_constant_error",
                                               "gravity_imbalance",
                                               "load_inertia_error",
                                               "load_mass_error",
                                               "channel_delay",
                                               "torque_offset",
                                               "current_offset",
                                               "velocity_mismatch"};
  return kNames;
}

const char* name_of(LogClass log_class) {
  constexpr std::array<const char*, 6> kNames{"none",        "one",     "two",
                                              "cannot_tell", "outside", "short"};
  return kNames[static_cast<std::size_t>(log_class)];
}

Scenario draw_effect(const std::string& effect, std::uint64_t seed) {
  return with_one(effect, LogClass::kOne, seed);
}

Scenario draw(LogClass log_class, std::uint64_t seed) {
  const std::vector<std::string>& names = drawn_effects();
  switch (log_class) {
    case LogClass::kNone:
      return with_nothing(seed);
    case LogClass::kOne:
    case LogClass::kShort:
      return with_one(names[seed % names.size()], log_class, seed);
    case LogClass::kTwo:
      return with_two(seed);
    case LogClass::kCannotTell:
      return draw_poor(seed);
    case LogClass::kOutside:
      return draw_outside(seed);
  }
  throw std::invalid_argument("no such class");
}

}  // namespace torquewright::oracles
