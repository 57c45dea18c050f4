// SPDX-License-Identifier: Apache-2.0
// What follows the winding's or the case's temperature.
#include "actuator/region/torque_at.hpp"
#include "identification/effects/families.hpp"

namespace torquewright::identification {
namespace {

constexpr double kLeastWarmth_K = 2.0;

double warmth_K(const actuator::Instant& at) {
  return at.winding_temperature_K - at.reference_temperature_K;
}

void add_friction(DictionaryBuilder& builder) {
  builder.set_nominal_drag_warmed(builder.add(
      "nominal drag times T", [balance = builder.balance()](const Signals& signals, std::size_t i) {
        return balance->gain(signals, i) *
               actuator::drag_Nm(balance->bench().actuator(), signals.at[i]) *
               warmth_K(signals.at[i]);
      }));
  Variant& friction = builder.variant("friction_temperature", {{{}, -0.1, 0.1}});
  friction.scales_friction = true;
  friction.is_temperature_effect = true;
}

}  // namespace

void add_temperature(DictionaryBuilder& builder) {
  const Bench& bench = builder.bench();
  if (!bench.has_temperature || builder.extent().warmth_K < kLeastWarmth_K) return;
  const std::size_t constant = builder.add(
      "torque constant times T",
      [balance = builder.balance()](const Signals& signals, std::size_t i) {
        return balance->gain(signals, i) * balance->driven_Nm(signals, i) * warmth_K(signals.at[i]);
      });
  builder.variant("torque_constant_temperature", {one(constant, -0.02, 0.02)})
      .is_temperature_effect = true;
  add_friction(builder);
  if (bench.drive != Drive::kVoltage || bench.load_side != LoadSide::kModel) return;
  const std::size_t resistance = builder.add(
      "resistance times T", [balance = builder.balance()](const Signals& signals, std::size_t i) {
        return -balance->driven_Nm(signals, i) * warmth_K(signals.at[i]);
      });
  builder.variant("winding_resistance_temperature", {one(resistance, -0.02, 0.02)})
      .is_temperature_effect = true;
}

}  // namespace torquewright::identification
