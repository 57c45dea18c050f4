// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/histories.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "identification/signals/signal.hpp"

namespace torquewright::identification {
namespace {

using actuator::Instant;

/// Parts of a step of the log over which a state is carried: each is one more evaluation of its
/// rate.
constexpr int kParts = 4;

/// A rate that is linear in its state: d state / dt = at_rest + slope state.
struct LinearRate {
  double at_rest, slope;
};
LinearRate rate_at(const actuator::Effect& effect, Instant& at, double state) {
  at.state = 0.0;
  const double at_rest = effect.kind->state_rate(effect, at);
  at.state = std::max(1e-9, std::abs(state));
  return {at_rest, (effect.kind->state_rate(effect, at) - at_rest) / at.state};
}

/// The state after a step, exact where what it settles to moves evenly.
double advanced_state(const LinearRate& begin, const LinearRate& end, double state, double step_s) {
  if (end.slope > -1e-12) {
    return state + step_s * (0.5 * (begin.at_rest + end.at_rest) + end.slope * state);
  }
  const double settled_before = -begin.at_rest / end.slope, settled = -end.at_rest / end.slope;
  const double behind = -(settled - settled_before) / step_s / end.slope;
  return settled - behind + (state - settled_before + behind) * std::exp(end.slope * step_s);
}

/// Where a signal passes at the beginning of a step, between its parts, and at its end.
using AtParts = std::array<double, kParts + 1>;

/// The cubic through the samples around a step; beyond an end the last sample stands for all.
/// `value_at`: of a sample.
template <typename ValueAt>
AtParts at_parts(std::size_t step, std::size_t samples, const ValueAt& value_at) {
  static const std::array<std::array<double, 4>, kParts + 1> kWeights = [] {
    std::array<std::array<double, 4>, kParts + 1> weights;
    for (int p = 0; p <= kParts; ++p)
      weights[static_cast<std::size_t>(p)] = cubic_weights(static_cast<double>(p) / kParts);
    return weights;
  }();
  const double before = value_at(step > 0 ? step - 1 : 0), from = value_at(step);
  const double to = value_at(step + 1), after = value_at(std::min(step + 2, samples - 1));
  AtParts values;
  for (std::size_t p = 0; p < values.size(); ++p) {
    const std::array<double, 4>& weight = kWeights[p];
    values[p] = weight[0] * before + weight[1] * from + weight[2] * to + weight[3] * after;
  }
  return values;
}

/// The effect's torque, at every part of every step. Friction follows the motion alone, a lag the
/// motor's torque.
std::vector<double> torque_at_parts_Nm(const actuator::Effect& effect,
                                       const std::vector<Instant>& at,
                                       const std::vector<double>& speeds_rad_s,
                                       const std::vector<double>& motor_Nm, double step_s) {
  const std::size_t n = at.size();
  const double part_s = step_s / kParts;
  const bool is_friction = !effect.kind->follows_torque;
  std::vector<double> torque_Nm;
  torque_Nm.reserve(n * kParts);
  double state = is_friction ? 0.0 : motor_Nm.front();
  Instant now = at.front();
  const auto add = [&](double input_Nm) {
    now.state = state;
    now.input = input_Nm;
    torque_Nm.push_back(effect.kind->law(effect, now));
  };
  for (std::size_t i = 0; i + 1 < n; ++i) {
    now = at[i];
    AtParts input{};
    if (!is_friction) input = at_parts(i, n, [&](std::size_t sample) { return motor_Nm[sample]; });
    for (std::size_t part = 0; part < kParts; ++part) {
      add(input[part]);
      now.speed_rad_s = speeds_rad_s[i * kParts + part];
      now.direction = now.speed_rad_s > 0.0 ? 1.0 : now.speed_rad_s < 0.0 ? -1.0 : 0.0;
      const LinearRate begin = rate_at(effect, now, state);
      LinearRate end = begin;
      if (!is_friction) {
        now.input = input[part + 1];
        end = rate_at(effect, now, state);
      }
      state = advanced_state(begin, end, state, part_s);
    }
  }
  now = at.back();
  add(is_friction ? 0.0 : motor_Nm.back());
  return torque_Nm;
}

bool is_neutral(const actuator::Effect& effect) {
  return effect.values.front() == effect.kind->parameters.front().neutral;
}

}  // namespace

bool has_history(const actuator::Effect& effect) {
  return effect.kind->state_rate != nullptr && effect.kind->in_train == actuator::TrainPart::kNone;
}

std::vector<double> speeds_of_parts_rad_s(const std::vector<Instant>& at, double step_s) {
  const double part_s = step_s / kParts;
  std::vector<double> speeds_rad_s;
  for (std::size_t i = 0; i + 1 < at.size() && step_s > 0.0; ++i) {
    const AtParts angle_rad =
        at_parts(i, at.size(), [&](std::size_t sample) { return at[sample].output_angle_rad; });
    for (std::size_t part = 0; part < kParts; ++part) {
      speeds_rad_s.push_back((angle_rad[part + 1] - angle_rad[part]) / part_s);
    }
  }
  return speeds_rad_s;
}

std::vector<double> torque_of_history_Nm(const actuator::Effect& effect,
                                         const std::vector<Instant>& at,
                                         const std::vector<double>& speeds_rad_s,
                                         const std::vector<double>& motor_Nm, double step_s,
                                         double cutoff_Hz) {
  std::vector<double> torque_Nm(at.size(), 0.0);
  if (at.empty() || !(step_s > 0.0) || is_neutral(effect)) return torque_Nm;
  std::vector<double> parts_Nm = torque_at_parts_Nm(effect, at, speeds_rad_s, motor_Nm, step_s);
  const bool is_friction = !effect.kind->follows_torque;
  if (is_friction && cutoff_Hz > 0.0) LowPass(cutoff_Hz, kParts / step_s).apply(parts_Nm);
  for (std::size_t i = 0; i < at.size(); ++i) torque_Nm[i] = parts_Nm[i * kParts];
  return torque_Nm;
}

}  // namespace torquewright::identification
