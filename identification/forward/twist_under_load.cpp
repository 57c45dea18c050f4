// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/twist_under_load.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::identification {
namespace {

using actuator::Actuator;
using actuator::Effect;
using actuator::Instant;
using actuator::TrainPart;

constexpr int kNewtonSteps = 4;  ///< From below they at least square the error.

double static_twist_rad(const Actuator& actuator, double torque_Nm) {
  double twist_rad = 0.0;
  for (const Effect& effect : actuator.effects) {
    if (effect.kind->twist_rad == nullptr) continue;
    twist_rad += effect.kind->twist_rad(effect, torque_Nm);
  }
  return twist_rad;
}

const Effect* hysteresis_of(const Actuator& actuator) {
  for (const Effect& effect : actuator.effects) {
    if (effect.kind->in_train == TrainPart::kHysteresis && effect.values[0] > 0.0) return &effect;
  }
  return nullptr;
}

/// Of the springs in series; infinite: the train is rigid.
double spring_Nm_rad(const Actuator& actuator) {
  double rad_Nm = 0.0;
  for (const Effect& effect : actuator.effects) {
    if (effect.kind->in_train != TrainPart::kSpring) continue;
    rad_Nm += effect.kind->twist_rad(effect, 1.0);
  }
  return 1.0 / rad_Nm;
}

/// Hysteresis beside a spring: both have one twist, and share the torque.
class SharedTwist {
 public:
  SharedTwist(const Effect& hysteresis, double spring_Nm_rad)
      : hysteresis_(hysteresis), spring_Nm_rad_(spring_Nm_rad) {}

  /// What the spring carries of a torque that follows the last one.
  double spring_torque_Nm(double torque_Nm) {
    const double more_Nm = torque_Nm - spring_Nm_rad_ * twist_rad_ - law_Nm(state_);
    const double direction = more_Nm < 0.0 ? -1.0 : 1.0;
    double by_rad = 0.0;  // in size; the least is taken first, and the slope falls along
    double state = state_;
    for (int i = 0; i < kNewtonSteps; ++i) {
      const double missing_Nm =
          direction * (more_Nm - law_Nm(state) + law_Nm(state_)) - spring_Nm_rad_ * by_rad;
      by_rad = std::max(0.0, by_rad + missing_Nm / slope_Nm_rad(state, direction));
      state = state_after(by_rad, direction);
    }
    twist_rad_ += direction * by_rad;
    state_ = state;
    return torque_Nm - law_Nm(state_);
  }

 private:
  double law_Nm(double state) const {
    Instant at;
    at.state = state;
    return hysteresis_.kind->law(hysteresis_, at);
  }

  /// d state / d twist: no rate of such an effect knows the time.
  double state_per_rad(double state, double direction) const {
    Instant at;
    at.state = state;
    at.twist_rate_rad_s = direction;
    return hysteresis_.kind->state_rate(hysteresis_, at);
  }

  /// Rates are linear in their state: what they settle to is approached exponentially.
  double state_after(double by_rad, double direction) const {
    const double rate_1_rad = state_per_rad(state_, direction);
    const double slope_1_rad = state_per_rad(state_ + 1.0, direction) - rate_1_rad;
    if (slope_1_rad == 0.0) return state_ + rate_1_rad * by_rad;
    return state_ + rate_1_rad / slope_1_rad * std::expm1(slope_1_rad * by_rad);
  }

  double slope_Nm_rad(double state, double direction) const {
    constexpr double kStep = 1e-6;  // of the state, which has no unit and is about 1
    const double law_slope_Nm = (law_Nm(state + kStep) - law_Nm(state - kStep)) / (2.0 * kStep);
    return spring_Nm_rad_ + law_slope_Nm * direction * state_per_rad(state, direction);
  }

  const Effect& hysteresis_;
  double spring_Nm_rad_;
  double twist_rad_ = 0.0, state_ = 0.0;
};

}  // namespace

std::vector<double> twist_under_load_rad(const Actuator& actuator, const std::vector<Instant>& at) {
  std::vector<double> twist_rad(at.size());
  const Effect* hysteresis = hysteresis_of(actuator);
  const double stiffness_Nm_rad = spring_Nm_rad(actuator);
  if (hysteresis == nullptr || !std::isfinite(stiffness_Nm_rad)) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      twist_rad[i] = static_twist_rad(actuator, at[i].load_torque_Nm);
    }
    return twist_rad;
  }
  SharedTwist shared(*hysteresis, stiffness_Nm_rad);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double torque_Nm = at[i].load_torque_Nm;
    const double taken_Nm = torque_Nm - shared.spring_torque_Nm(torque_Nm);
    // A gap is as wide as it is, whatever part of the torque the spring carries.
    twist_rad[i] = static_twist_rad(actuator, torque_Nm) - taken_Nm / stiffness_Nm_rad;
  }
  return twist_rad;
}

}  // namespace torquewright::identification
