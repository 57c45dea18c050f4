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

/// d state / dt where the state is 0.
double rate_at_rest(const actuator::Effect& effect, Instant& at) {
  at.state = 0.0;
  return effect.kind->state_rate(effect, at);
}

/// Slope of the rate, which is linear in the state, from its value at 0 to a state.
double slope_of_rate(const actuator::Effect& effect, Instant& at, double at_rest, double state) {
  at.state = std::max(1e-9, std::abs(state));
  return (effect.kind->state_rate(effect, at) - at_rest) / at.state;
}

/// The state after a step, exact where what it settles to moves evenly; `before` and `after`: the
/// rates at rest at the step's ends.
double advanced_state(double before, double after, double slope, double state, double step_s) {
  if (slope > -1e-12) return state + step_s * (0.5 * (before + after) + slope * state);
  const double settled_before = -before / slope, settled = -after / slope;
  const double behind = -(settled - settled_before) / step_s / slope;
  return settled - behind + (state - settled_before + behind) * std::exp(slope * step_s);
}

/// The same where that does not move.
double advanced_state(double at_rest, double slope, double state, double step_s) {
  if (slope > -1e-12) return state + step_s * (at_rest + slope * state);
  const double settled = -at_rest / slope;
  return settled + (state - settled) * std::exp(slope * step_s);
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

/// Where the history of an effect stands, through the steps of a stretch.
class History {
 public:
  History(const actuator::Effect& effect, double state, double part_s)
      : effect_(effect), state_(state), part_s_(part_s) {}

  double torque_Nm(Instant& now) const {
    now.state = state_;
    return effect_.kind->law(effect_, now);
  }

  /// Friction, over a part of a step in which the speed of `now` does not change.
  void follow_motion(Instant& now) {
    const double at_rest = rate_at_rest(effect_, now);
    const double slope = slope_of_rate(effect_, now, at_rest, state_);
    state_ = advanced_state(at_rest, slope, state_, part_s_);
  }

  /// A lag, over a part at whose end the input is that of `now`. `before`: the rate at rest at its
  /// beginning, which becomes that at its end.
  void follow_torque(Instant& now, double& before) {
    const double after = rate_at_rest(effect_, now);
    const double slope = slope_of_rate(effect_, now, after, state_);
    state_ = advanced_state(before, after, slope, state_, part_s_);
    before = after;
  }

 private:
  const actuator::Effect& effect_;
  double state_, part_s_;
};

/// Torque at every part of every step.
std::vector<double> friction_at_parts_Nm(const actuator::Effect& effect,
                                         const std::vector<Instant>& at,
                                         const std::vector<double>& speeds_rad_s, double part_s) {
  History history(effect, 0.0, part_s);
  std::vector<double> torque_Nm;
  torque_Nm.reserve(speeds_rad_s.size() + 1);
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    Instant now = at[i];
    for (std::size_t part = 0; part < kParts; ++part) {
      torque_Nm.push_back(history.torque_Nm(now));
      now.speed_rad_s = speeds_rad_s[i * kParts + part];
      now.direction = now.speed_rad_s > 0.0 ? 1.0 : now.speed_rad_s < 0.0 ? -1.0 : 0.0;
      history.follow_motion(now);
    }
  }
  Instant last = at.back();
  torque_Nm.push_back(history.torque_Nm(last));
  return torque_Nm;
}

/// Torque at every sample.
std::vector<double> lag_at_samples_Nm(const actuator::Effect& effect,
                                      const std::vector<Instant>& at,
                                      const std::vector<double>& motor_Nm, double part_s) {
  History history(effect, motor_Nm.front(), part_s);
  std::vector<double> torque_Nm;
  torque_Nm.reserve(at.size());
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    Instant now = at[i];
    const AtParts input =
        at_parts(i, at.size(), [&](std::size_t sample) { return motor_Nm[sample]; });
    now.input = input.front();
    torque_Nm.push_back(history.torque_Nm(now));
    double rate = rate_at_rest(effect, now);
    for (std::size_t part = 0; part < kParts; ++part) {
      now.input = input[part + 1];
      history.follow_torque(now, rate);
    }
  }
  Instant last = at.back();
  last.input = motor_Nm.back();
  torque_Nm.push_back(history.torque_Nm(last));
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

std::vector<double> friction_history_Nm(const actuator::Effect& effect,
                                        const std::vector<Instant>& at,
                                        const std::vector<double>& speeds_rad_s, double step_s,
                                        double cutoff_Hz) {
  std::vector<double> torque_Nm(at.size(), 0.0);
  if (at.empty() || !(step_s > 0.0) || is_neutral(effect)) return torque_Nm;
  std::vector<double> parts_Nm = friction_at_parts_Nm(effect, at, speeds_rad_s, step_s / kParts);
  if (cutoff_Hz > 0.0) LowPass(cutoff_Hz, kParts / step_s).apply(parts_Nm);
  for (std::size_t i = 0; i < at.size(); ++i) torque_Nm[i] = parts_Nm[i * kParts];
  return torque_Nm;
}

std::vector<double> lag_history_Nm(const actuator::Effect& effect, const std::vector<Instant>& at,
                                   const std::vector<double>& motor_Nm, double step_s) {
  const bool is_nothing = at.empty() || !(step_s > 0.0) || is_neutral(effect);
  return is_nothing ? std::vector<double>(at.size(), 0.0)
                    : lag_at_samples_Nm(effect, at, motor_Nm, step_s / kParts);
}

}  // namespace torquewright::identification
