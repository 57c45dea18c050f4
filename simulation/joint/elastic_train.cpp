// SPDX-License-Identifier: Apache-2.0
#include "simulation/joint/elastic_train.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torquewright::simulation {
namespace {

// Flanks of a gap without a stated stiffness meet at this frequency, nearly critically damped:
// above what samples at 1 kHz resolve, and slow enough for steps of 0.1 ms.
constexpr double kContact_rad_s = 1000.0;
constexpr double kContactDamping = 0.6;
// Steps per radian of the fastest oscillation. A twist that is hardly damped keeps its phase over
// hundreds of radians only with many; a well damped contact needs few.
constexpr double kTwistSteps = 200.0;
constexpr double kContactSteps = 10.0;

bool is_open_gap(const actuator::Effect& effect) {
  return effect.kind->in_train == actuator::TrainPart::kGap && effect.values[0] > 0.0;
}

bool is_soft_spring(const actuator::Effect& effect) {
  return effect.kind->in_train == actuator::TrainPart::kSpring && std::isfinite(effect.values[0]);
}

bool is_hysteresis(const actuator::Effect& effect) {
  return effect.kind->in_train == actuator::TrainPart::kHysteresis;
}

/// How many states stand before the effect's in a joint's state.
std::size_t states_before(const actuator::Actuator& actuator, const actuator::Effect* effect) {
  std::size_t count = 0;
  for (const actuator::Effect& each : actuator.effects) {
    if (&each == effect) break;
    if (each.kind->state_rate != nullptr) ++count;
  }
  return count;
}

/// The first effect that is one; null: none.
const actuator::Effect* first_that(bool (*is_one)(const actuator::Effect&),
                                   const actuator::Actuator& actuator) {
  for (const actuator::Effect& effect : actuator.effects) {
    if (is_one(effect)) return &effect;
  }
  return nullptr;
}

double step_s(double rate_rad_s, double steps) {
  return rate_rad_s > 0.0 ? 1.0 / (steps * rate_rad_s) : std::numeric_limits<double>::infinity();
}

}  // namespace

bool makes_train_elastic(const actuator::Effect& effect) {
  return is_open_gap(effect) || is_soft_spring(effect);
}

bool states_elastic_train(const actuator::Actuator& actuator) {
  return first_that(makes_train_elastic, actuator) != nullptr;
}

ElasticTrain::ElasticTrain(const actuator::Actuator& actuator, double inertia_kg_m2)
    : actuator_(actuator),
      inertia_kg_m2_(inertia_kg_m2),
      is_elastic_(states_elastic_train(actuator) && inertia_kg_m2 > 0.0),
      gap_(first_that(is_open_gap, actuator)),
      spring_(first_that(is_soft_spring, actuator)),
      hysteresis_(spring_ == nullptr ? nullptr : first_that(is_hysteresis, actuator)),
      state_of_hysteresis_(states_before(actuator, hysteresis_)),
      contact_Nm_rad_(inertia_kg_m2 * kContact_rad_s * kContact_rad_s),
      contact_Nm_s_rad_(2.0 * kContactDamping * kContact_rad_s * inertia_kg_m2) {}

double ElasticTrain::spring_Nm_rad() const {
  return spring_ != nullptr ? spring_->values[0] : contact_Nm_rad_;
}

double ElasticTrain::stiffness_Nm_rad() const {
  if (!is_elastic_) return 0.0;
  const double beside_Nm_rad =
      hysteresis_ != nullptr ? hysteresis_->kind->stiffness_Nm_rad(*hysteresis_) : 0.0;
  return spring_Nm_rad() + beside_Nm_rad;
}

double ElasticTrain::hysteresis_Nm(const JointState& state, const actuator::Instant& at) const {
  if (hysteresis_ == nullptr || state.of_effect.empty()) return 0.0;
  actuator::Instant with_state = at;
  with_state.state = state.of_effect[state_of_hysteresis_];
  return hysteresis_->kind->law(*hysteresis_, with_state);
}

bool ElasticTrain::is_tight(const JointState& state) const {
  if (!is_elastic_ || gap_ == nullptr) return is_elastic_;
  return gap_->kind->law(*gap_, instant_of(actuator_, state, 0.0)) != 0.0;
}

double ElasticTrain::damping_Nm_s_rad() const {
  if (!is_elastic_) return 0.0;
  return spring_ != nullptr ? spring_->values[1] : contact_Nm_s_rad_;
}

double ElasticTrain::longest_step_s(double felt_inertia_kg_m2) const {
  const double load = felt_inertia_kg_m2 > 0.0 ? 1.0 / felt_inertia_kg_m2 : 0.0;
  const double swing_s = step_s(std::sqrt(stiffness_Nm_rad() * (1.0 / inertia_kg_m2_ + load)),
                                spring_ != nullptr ? kTwistSteps : kContactSteps);
  return std::min(swing_s,
                  step_s(damping_Nm_s_rad() * (1.0 / inertia_kg_m2_ + load), kContactSteps));
}

double ElasticTrain::twist_rad_under(double torque_Nm) const {
  if (!is_elastic_ || torque_Nm == 0.0) return 0.0;
  const double gap_rad = gap_ != nullptr ? gap_->values[0] : 0.0;
  // A spring without stiffness carries nothing at any twist.
  const double elastic_rad = spring_Nm_rad() > 0.0 ? torque_Nm / spring_Nm_rad() : 0.0;
  return elastic_rad + std::copysign(0.5 * gap_rad, torque_Nm);
}

ElasticTrain::Twist ElasticTrain::twist(const JointState& state) const {
  actuator::Instant at = instant_of(actuator_, state, 0.0);
  if (gap_ != nullptr) at.twist_rad = gap_->kind->law(*gap_, at);
  if (gap_ != nullptr && at.twist_rad == 0.0) return {};
  Twist twist;
  if (spring_ != nullptr) {
    twist.damping_Nm = spring_->values[1] * at.twist_rate_rad_s;
    twist.torque_Nm = spring_->kind->law(*spring_, at);
    twist.stored_J = 0.5 * (twist.torque_Nm - twist.damping_Nm) * at.twist_rad;
    // What it stores for a while counts as lost until it is given back.
    const double hysteresis_Nm = this->hysteresis_Nm(state, at);
    twist.damping_Nm += hysteresis_Nm;
    twist.torque_Nm += hysteresis_Nm;
  } else {
    twist.damping_Nm = contact_Nm_s_rad_ * at.twist_rate_rad_s;
    twist.torque_Nm = contact_Nm_rad_ * at.twist_rad + twist.damping_Nm;
    twist.stored_J = 0.5 * contact_Nm_rad_ * at.twist_rad * at.twist_rad;
  }
  if (gap_ != nullptr && twist.torque_Nm * at.twist_rad < 0.0) {
    // Flanks push, they do not pull.
    twist.damping_Nm -= twist.torque_Nm;
    twist.torque_Nm = 0.0;
  }
  return twist;
}

}  // namespace torquewright::simulation
