// SPDX-License-Identifier: Apache-2.0
#include "actuator/heat/heat_model.hpp"

#include <cmath>

#include "actuator/heat/temperature_laws.hpp"

namespace torquewright::actuator {
namespace {

std::array<double, 4> product(const std::array<double, 4>& left,
                              const std::array<double, 4>& right) {
  return {left[0] * right[0] + left[1] * right[2], left[0] * right[1] + left[1] * right[3],
          left[2] * right[0] + left[3] * right[2], left[2] * right[1] + left[3] * right[3]};
}

/// (e^x - 1) / x.
double mean_exponential(double x) { return std::abs(x) < 1e-12 ? 1.0 : std::expm1(x) / x; }

/// dT/dt of both nodes. Eq. (5), temperatures instead of warmth.
NodeTemperatures rates_K_s(const Thermal& thermal, const NodeTemperatures& nodes, double loss_W) {
  const double inner_W = (nodes.winding_K - nodes.case_K) / thermal.winding_to_case_K_W;
  const double outer_W = (nodes.case_K - thermal.ambient_K) / thermal.case_to_ambient_K_W;
  return {(loss_W - inner_W) / thermal.winding_J_K, (inner_W - outer_W) / thermal.case_J_K};
}

/// Where those rates lead after a time.
NodeTemperatures moved(const NodeTemperatures& from, double step_s, const NodeTemperatures& rates) {
  return {from.winding_K + step_s * rates.winding_K, from.case_K + step_s * rates.case_K};
}

}  // namespace

Warmth HeatStep::after(const Warmth& warmth) const {
  return {map[0] * warmth[0] + map[1] * warmth[1] + shift[0],
          map[2] * warmth[0] + map[3] * warmth[1] + shift[1]};
}

HeatStep then(const HeatStep& first, const HeatStep& second) {
  return {product(second.map, first.map), second.after(first.shift),
          first.duration_s + second.duration_s};
}

HeatModel::HeatModel(const Actuator& actuator) : thermal_(*actuator.thermal) {
  // The resistance is linear in the temperature: two places tell it.
  constexpr double kSpan_K = 100.0;
  resistance_ohm_ = phase_resistance_ohm(actuator, thermal_.ambient_K);
  resistance_ohm_per_K_ =
      (phase_resistance_ohm(actuator, thermal_.ambient_K + kSpan_K) - resistance_ohm_) / kSpan_K;
}

HeatStep HeatModel::step(double square_A2, double duration_s) const {
  // x' = M x + c, x the warmth: eq. (5).
  const double winding_1_s = 1.0 / (thermal_.winding_to_case_K_W * thermal_.winding_J_K);
  const double case_1_s = 1.0 / (thermal_.winding_to_case_K_W * thermal_.case_J_K);
  const double ambient_1_s = 1.0 / (thermal_.case_to_ambient_K_W * thermal_.case_J_K);
  const double growth_1_s = 1.5 * square_A2 * resistance_ohm_per_K_ / thermal_.winding_J_K;
  const double heating_K_s = 1.5 * square_A2 * resistance_ohm_ / thermal_.winding_J_K;
  const double m11 = growth_1_s - winding_1_s;
  const double m12 = winding_1_s;
  const double m21 = case_1_s;
  const double m22 = -case_1_s - ambient_1_s;
  // Both eigenvalues are real, since m12 m21 > 0: eq. (6).
  const double middle_1_s = 0.5 * (m11 + m22);
  const double half_1_s = std::hypot(0.5 * (m11 - m22), std::sqrt(m12 * m21));
  const double slow = (middle_1_s + half_1_s) * duration_s;
  const double fast = (middle_1_s - half_1_s) * duration_s;
  // exp(M t) = f0 + f1 M and its integral over t, g0 + g1 M, by their values at the eigenvalues.
  const double f1 = (std::exp(slow) - std::exp(fast)) / (2.0 * half_1_s);
  const double f0 = std::exp(slow) - f1 * (middle_1_s + half_1_s);
  const double g_slow = duration_s * mean_exponential(slow);
  const double g1 = (g_slow - duration_s * mean_exponential(fast)) / (2.0 * half_1_s);
  const double g0 = g_slow - g1 * (middle_1_s + half_1_s);
  return {{f0 + f1 * m11, f1 * m12, f1 * m21, f0 + f1 * m22},
          {(g0 + g1 * m11) * heating_K_s, g1 * m21 * heating_K_s},
          duration_s};
}

void HeatModel::advance(NodeTemperatures& nodes, double loss_W, double step_s) const {
  const NodeTemperatures middle = moved(nodes, 0.5 * step_s, rates_K_s(thermal_, nodes, loss_W));
  nodes = moved(nodes, step_s, rates_K_s(thermal_, middle, loss_W));
}

}  // namespace torquewright::actuator
