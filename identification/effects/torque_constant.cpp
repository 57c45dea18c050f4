// SPDX-License-Identifier: Apache-2.0
// A torque constant that is not the stated one, or falls with current.
#include "identification/effects/families.hpp"

namespace torquewright::identification {
namespace {

/// A torque factor's part beyond 1, times the torque that it multiplies.
std::size_t add_factor(DictionaryBuilder& builder, const std::string& name,
                       actuator::Effect effect) {
  const actuator::Actuator& actuator = builder.bench().actuator();
  const double per_ampere = actuator.transmission.ratio * actuator.motor.torque_constant_Nm_A;
  return builder.add(name, [balance = builder.balance(), effect = std::move(effect), per_ampere](
                               const Signals& signals, std::size_t i) {
    const double driven_Nm = balance->driven_Nm(signals, i);
    actuator::Instant at = signals.at[i];
    at.current_A = driven_Nm / per_ampere;
    const double factor = effect.kind->law(effect, at);
    // A motor-side target needs the torque divided by the factor.
    return balance->is_sensor() ? balance->gain(signals, i) * driven_Nm * (factor - 1.0)
                                : driven_Nm * (1.0 - 1.0 / factor);
  });
}

void add_saturation(DictionaryBuilder& builder, const std::vector<double>& grid_A,
                    double exponent) {
  constexpr const char* kName = "torque_constant_saturation";
  std::vector<std::size_t> columns;
  for (const double limit_A : grid_A) {
    columns.push_back(add_factor(builder, "saturation", effect_with(kName, {limit_A, exponent})));
  }
  for (std::size_t k = 0; k + 1 < grid_A.size(); ++k) {
    builder.variant(kName, {one(columns[k], 0.0, 1.5), one(columns[k + 1], 0.0, 1.5)}).shape = {
        {grid_A[k], exponent}, {grid_A[k + 1], exponent}};
  }
  for (std::size_t k = 0; k < grid_A.size(); ++k) {
    builder.variant(kName, {one(columns[k], 0.0, 1.5)}).shape = {{grid_A[k], exponent}};
  }
}

}  // namespace

void add_torque_constant(DictionaryBuilder& builder) {
  const std::size_t driven = builder.add(
      "torque constant", [balance = builder.balance()](const Signals& signals, std::size_t i) {
        return balance->of_torque_constant_Nm(signals, i);
      });
  builder.variant("torque_constant_error", {one(driven, -0.7, 3.0)});
  // The driver's torque says nothing of the current.
  if (builder.bench().drive == Drive::kTorque) return;
  const double large_A = builder.extent().current_A;
  const std::vector<double> grid_A = geometric(0.5 * large_A, 5.0 * large_A, 8);
  for (const double exponent : {1.5, 2.0, 2.5, 3.0, 4.0, 6.0})
    add_saturation(builder, grid_A, exponent);
}

}  // namespace torquewright::identification
