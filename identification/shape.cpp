// SPDX-License-Identifier: Apache-2.0
#include "identification/shape.hpp"

#include <algorithm>
#include <cmath>

#include "identification/backlash_residual.hpp"
#include "identification/effects/dictionary_builder.hpp"

namespace torquewright::identification {
namespace {

using actuator::Effect;
using actuator::Instant;

/// Mean of the grid's values by the weights that the regression gave them.
double grid_mean(const Variant& variant, const std::vector<double>& weights,
                 std::size_t parameter) {
  double top = 0.0, bottom = 0.0;
  for (std::size_t j = 0; j < variant.shape.size(); ++j) {
    if (variant.shape[j].size() <= parameter) continue;
    const double weight = std::max(1e-9, weights[j]);
    top += weight * std::log(variant.shape[j][parameter]);
    bottom += weight;
  }
  return std::exp(top / bottom);
}

Column stribeck_column(std::shared_ptr<const Balance> balance, double speed_rad_s) {
  const Effect effect = effect_with("stribeck_friction", {0.0, 1.0, speed_rad_s});
  return {"stribeck", [balance, effect](const Signals& signals, std::vector<double>& out) {
            for (std::size_t i = 0; i < signals.size(); ++i) {
              out[i] = balance->gain(signals, i) * effect.kind->law(effect, signals.at[i]);
            }
          }};
}

Column presliding_shape(std::shared_ptr<const Balance> balance, double length_rad) {
  return {"presliding", [balance, length_rad](const Signals& signals, std::vector<double>& out) {
            double state = 0.0;
            for (std::size_t i = 0; i < signals.size(); ++i) {
              if (i > 0) {
                const double moved =
                    signals.at[i].output_angle_rad - signals.at[i - 1].output_angle_rad;
                const double goal = moved > 0.0 ? 1.0 : -1.0;
                state = goal + (state - goal) * std::exp(-std::abs(moved) / length_rad);
              }
              out[i] = -balance->gain(signals, i) * state;
            }
          }};
}

Column saturation_shape(std::shared_ptr<const Balance> balance, double limit_A, double exponent) {
  const Effect effect = effect_with("torque_constant_saturation", {limit_A, exponent});
  const actuator::Actuator& actuator = balance->bench().actuator();
  const double per_ampere = actuator.transmission.ratio * actuator.motor.torque_constant_Nm_A;
  return {"saturation",
          [balance, effect, per_ampere](const Signals& signals, std::vector<double>& out) {
            for (std::size_t i = 0; i < signals.size(); ++i) {
              const double driven_Nm = balance->driven_Nm(signals, i);
              Instant at = signals.at[i];
              at.current_A = driven_Nm / per_ampere;
              const double factor = effect.kind->law(effect, at);
              out[i] = balance->is_sensor() ? balance->gain(signals, i) * driven_Nm * (factor - 1.0)
                                            : driven_Nm * (1.0 - 1.0 / factor);
            }
          }};
}

/// Exact for an input that is straight between samples. Where the motor's side is the target, the
/// lag's inverse acts on what the load needs.
Column lag_shape(std::shared_ptr<const Balance> balance, double lag_s) {
  return {"lag", [balance, lag_s](const Signals& signals, std::vector<double>& out) {
            const double share = std::exp(-signals.step_s / lag_s);
            double state = 0.0, before = 0.0;
            for (std::size_t i = 0; i < signals.size(); ++i) {
              const double input = balance->driven_Nm(signals, i);
              if (i == 0) {
                state = input;
              } else if (balance->is_sensor()) {
                const double slope = (input - before) / signals.step_s;
                state = input - slope * lag_s + (state - before + slope * lag_s) * share;
              } else {
                state = input - lag_s * (input - before) / signals.step_s;
              }
              before = input;
              out[i] = balance->is_sensor() ? balance->gain(signals, i) * (state - input)
                                            : state - input;
            }
          }};
}

Column gap_shape(std::shared_ptr<const Balance> balance, double gap_rad) {
  return {"gap", [balance, gap_rad](const Signals& signals, std::vector<double>& out) {
            out = backlash_residual_Nm(*balance, gap_rad, signals);
          }};
}

}  // namespace

bool is_all_shape(const std::string& effect) {
  return effect == "torque_constant_saturation" || effect == "torque_lag" || effect == "backlash";
}

std::vector<ShapeParameter> shape_parameters(const Variant& variant,
                                             const std::vector<double>& weights,
                                             const Extent& extent) {
  const std::string& effect = variant.effect;
  if (effect == "stribeck_friction") {
    return {{"stribeck_velocity_rad_s", 0.003 * extent.speed_rad_s, 2.0 * extent.speed_rad_s,
             grid_mean(variant, weights, 0)}};
  }
  if (effect == "presliding_friction") {
    return {{"length_rad", 1e-4 * extent.output_angle_rad, extent.output_angle_rad,
             grid_mean(variant, weights, 0)}};
  }
  if (effect == "torque_constant_saturation") {
    return {{"saturation_current_A", 0.3 * extent.current_A, 20.0 * extent.current_A,
             grid_mean(variant, weights, 0)},
            {"exponent", 1.0, 8.0, variant.shape.front()[1]}};
  }
  if (effect == "torque_lag") {
    return {
        {"time_constant_s", 2e-4, 0.3, std::max(3e-4, variant.shape.front()[0] * weights.front())}};
  }
  if (effect == "backlash" && !variant.shape.empty()) {
    const double start_rad = variant.shape.front()[0] * weights.front();
    return {{"gap_rad", 0.2 * start_rad, 3.0 * start_rad, start_rad, 0.05}};
  }
  return {};
}

Column shaped_column(const std::shared_ptr<const Balance>& balance, const std::string& effect,
                     const std::vector<double>& shape) {
  if (effect == "stribeck_friction") return stribeck_column(balance, shape[0]);
  if (effect == "presliding_friction") return presliding_shape(balance, shape[0]);
  if (effect == "torque_constant_saturation") return saturation_shape(balance, shape[0], shape[1]);
  if (effect == "backlash") return gap_shape(balance, shape[0]);
  return lag_shape(balance, shape[0]);
}

}  // namespace torquewright::identification
