// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/histories.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "actuator/effects/effect.hpp"
#include "actuator/region/torque_at.hpp"
#include "identification/signal.hpp"

namespace torquewright::identification {
namespace {

using actuator::Instant;

constexpr int kParts = 4;  ///< Of a step.

/// A rate that is linear in its state: d state / dt = at_rest + slope state.
struct LinearRate {
  double at_rest, slope;
};
LinearRate rate_at(const actuator::Effect& effect, Instant at, double state) {
  at.state = 0.0;
  const double at_rest = effect.kind->state_rate(effect, at);
  at.state = std::max(1e-9, std::abs(state));
  return {at_rest, (effect.kind->state_rate(effect, at) - at_rest) / at.state};
}

/// The state after a step, exact where what it settles to moves evenly.
double advanced_state(const actuator::Effect& effect, const Instant& from, const Instant& to,
                      double state, double step_s) {
  const LinearRate begin = rate_at(effect, from, state), end = rate_at(effect, to, state);
  if (end.slope > -1e-12) {
    return state + step_s * (0.5 * (begin.at_rest + end.at_rest) + end.slope * state);
  }
  const double settled_before = -begin.at_rest / end.slope, settled = -end.at_rest / end.slope;
  const double behind = -(settled - settled_before) / step_s / end.slope;
  return settled - behind + (state - settled_before + behind) * std::exp(end.slope * step_s);
}

/// One effect, through the stretch.
void add_history(const actuator::Actuator& actuator, const actuator::Effect& effect,
                 const std::vector<Instant>& at, const std::vector<double>& motor_Nm, double step_s,
                 std::vector<double>& sum_Nm) {
  const std::size_t n = at.size();
  const bool is_friction = effect.kind->name != "torque_lag";
  const auto index = [&](std::size_t i, std::ptrdiff_t by) {
    return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
        static_cast<std::ptrdiff_t>(i) + by, 0, static_cast<std::ptrdiff_t>(n) - 1));
  };
  const auto input_at = [&](std::size_t i, double share) {
    return cubic_between(std::array{motor_Nm[index(i, -1)], motor_Nm[i], motor_Nm[index(i, 1)],
                                    motor_Nm[index(i, 2)]},
                         share);
  };
  const auto angle_at = [&](std::size_t i, double share) {
    return cubic_between(
        std::array{at[index(i, -1)].output_angle_rad, at[i].output_angle_rad,
                   at[index(i, 1)].output_angle_rad, at[index(i, 2)].output_angle_rad},
        share);
  };
  double state = is_friction ? 0.0 : motor_Nm.front();
  for (std::size_t i = 0; i < n; ++i) {
    Instant now = at[i];
    now.state = state;
    now.input = motor_Nm[i];
    const double torque_Nm = effect.kind->law(effect, now);
    sum_Nm[i] += is_friction ? torque_Nm * actuator::drag_factor(actuator, now) : torque_Nm;
    for (int part = 0; part < kParts && i + 1 < n; ++part) {
      const double from = static_cast<double>(part) / kParts, to = from + 1.0 / kParts;
      const double part_s = step_s / kParts;
      now.input = input_at(i, from);
      now.speed_rad_s = (angle_at(i, to) - angle_at(i, from)) / part_s;
      now.direction = now.speed_rad_s > 0.0 ? 1.0 : now.speed_rad_s < 0.0 ? -1.0 : 0.0;
      Instant then = now;
      then.input = input_at(i, to);
      state = advanced_state(effect, now, then, state, part_s);
    }
  }
}

bool is_neutral(const actuator::Effect& effect) {
  return effect.values.front() == effect.kind->parameters.front().neutral;
}

}  // namespace

std::vector<double> torque_of_histories_Nm(const actuator::Actuator& actuator,
                                           const std::vector<Instant>& at,
                                           const std::vector<double>& motor_Nm, double step_s) {
  std::vector<double> sum_Nm(at.size(), 0.0);
  if (at.empty() || !(step_s > 0.0)) return sum_Nm;
  for (const actuator::Effect& effect : actuator.effects) {
    if (effect.kind->state_rate != nullptr && !is_neutral(effect)) {
      add_history(actuator, effect, at, motor_Nm, step_s, sum_Nm);
    }
  }
  return sum_Nm;
}

}  // namespace torquewright::identification
