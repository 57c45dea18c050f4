// SPDX-License-Identifier: Apache-2.0
#include "simulation/joint/joint_model.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/heat/temperature_laws.hpp"
#include "actuator/region/gear_losses.hpp"
#include "actuator/region/torque_at.hpp"
#include "simulation/sign.hpp"

namespace torquewright::simulation {
namespace {

using actuator::Effect;
using actuator::Instant;

constexpr double kSpringSteps = 10.0;  ///< Per radian of the oscillation.

/// x(h) of dx/dt = rate + slope (x - x0).
double exponential_step(double state, double rate, double slope, double step_s) {
  const double z = slope * step_s;
  const double phi = std::abs(z) < 1e-8 ? 1.0 + 0.5 * z : std::expm1(z) / z;
  return state + step_s * phi * rate;
}

/// Of what stands between frame and output: a spring, a stop, friction's bristles.
double stiffness_to_frame_Nm_rad(const Effect& effect) {
  const actuator::EffectKind& kind = *effect.kind;
  if (kind.in_train != actuator::TrainPart::kNone || kind.stiffness_Nm_rad == nullptr) return 0.0;
  const double stiffness_Nm_rad = kind.stiffness_Nm_rad(effect);
  return std::isfinite(stiffness_Nm_rad) ? stiffness_Nm_rad : 0.0;
}

double frame_Nm_rad(const actuator::Actuator& actuator) {
  double stiffness_Nm_rad = 0.0;
  for (const Effect& effect : actuator.effects) {
    stiffness_Nm_rad += stiffness_to_frame_Nm_rad(effect);
  }
  return stiffness_Nm_rad;
}

double spring_rad_s(const actuator::Actuator& actuator, double inertia_kg_m2) {
  const double stiffness_Nm_rad = frame_Nm_rad(actuator);
  return inertia_kg_m2 > 0.0 ? std::sqrt(stiffness_Nm_rad / inertia_kg_m2) : 0.0;
}

}  // namespace

JointModel::JointModel(const actuator::Actuator& actuator, double felt_inertia_kg_m2,
                       const SimulationOptions& options)
    : actuator_(actuator),
      circuit_(actuator, options.inductance),
      inertia_kg_m2_(
          options.motor_inertia_kg_m2.value_or(actuator::reflected_inertia_kg_m2(actuator))),
      train_(actuator, inertia_kg_m2_),
      longest_step_s_(options.longest_step_s) {
  if (actuator.thermal) heat_.emplace(actuator);
  for (int way = 0; way < 2; ++way) {
    const double direction = way == 0 ? 1.0 : -1.0;
    gain_[way][0] = actuator::after_mesh_Nm(actuator, 1.0, direction);
    gain_[way][1] = -actuator::after_mesh_Nm(actuator, -1.0, direction);
  }
  const double springs_rad_s =
      spring_rad_s(actuator, inertia_kg_m2_ + (is_elastic() ? 0.0 : felt_inertia_kg_m2));
  if (springs_rad_s > 0.0) {
    longest_step_s_ = std::min(longest_step_s_, 1.0 / (kSpringSteps * springs_rad_s));
  }
  if (is_elastic()) {
    longest_step_s_ = std::min(longest_step_s_, train_.longest_step_s(felt_inertia_kg_m2));
  }
}

JointState JointModel::initial(const JointStart& start) const {
  JointState state;
  state.position_rad = state.motor_position_rad = start.position_rad;
  state.speed_rad_s = state.motor_speed_rad_s = start.speed_rad_s;
  if (is_elastic()) state.motor_position_rad += start.motor_ahead_rad;
  const double reference_K = actuator_.motor.winding_temperature_K;
  const double ambient_K = actuator_.thermal ? actuator_.thermal->ambient_K : reference_K;
  state.temperature.winding_K =
      start.winding_K.value_or(actuator_.thermal ? ambient_K : reference_K);
  state.temperature.case_K = start.case_K.value_or(ambient_K);
  for (const Effect& effect : actuator_.effects) {
    if (effect.kind->state_rate != nullptr) state.of_effect.push_back(0.0);
  }
  return state;
}

double JointModel::state_torque_Nm(const JointState& state, Instant at, double drag_factor,
                                   double* motor_Nm) const {
  double friction_Nm = 0.0;
  std::size_t next = 0;
  for (const Effect& effect : actuator_.effects) {
    if (effect.kind->state_rate == nullptr) continue;
    at.state = state.of_effect[next++];
    at.input = *motor_Nm;
    const double torque_Nm = effect.kind->law(effect, at);
    if (effect.kind->follows_torque) {
      // A time constant of zero follows at once.
      if (effect.values[0] > 0.0) *motor_Nm += torque_Nm;
    } else if (effect.kind->in_train == actuator::TrainPart::kNone) {
      friction_Nm += drag_factor * torque_Nm;
    }
  }
  return friction_Nm;
}

double JointModel::commanded_Nm(const Instant& at, const DriveNow& drive) const {
  return drive.motor_Nm ? *drive.motor_Nm : actuator::motor_torque_Nm(actuator_, at);
}

JointForces JointModel::forces(const JointState& state, double direction,
                               const DriveNow& drive) const {
  Instant at = instant_of(actuator_, state, direction);
  JointForces forces;
  forces.current_A = at.current_A = circuit_.current_A(state, drive);
  forces.motor_Nm = commanded_Nm(at, drive);
  forces.friction_Nm = actuator::drag_Nm(actuator_, at);
  if (!state.of_effect.empty()) {
    forces.friction_Nm +=
        state_torque_Nm(state, at, actuator::drag_factor(actuator_, at), &forces.motor_Nm);
  }
  forces.cogging_Nm = actuator::periodic_motor_torque_Nm(actuator_, at);
  forces.before_mesh_Nm = forces.motor_Nm + forces.friction_Nm + forces.cogging_Nm;
  forces.ripple_Nm = actuator::ripple_Nm(actuator_, at);
  at.load_torque_Nm = 1.0;
  forces.ripple_ratio = actuator::ripple_Nm(actuator_, at) - forces.ripple_Nm;
  const int way = direction < 0.0 ? 1 : 0;
  forces.gain_positive = gain_[way][0];
  forces.gain_negative = gain_[way][1];
  return forces;
}

template <typename Change>
void JointModel::change_states(JointState& state, const DriveNow& drive, Change change) const {
  if (circuit_.is_inductive(drive)) {
    const WindingCircuit::Rate rate = circuit_.current_rate(state, drive);
    change(state.current_A, rate.current_A_s, rate.slope_1_s);
  }
  if (state.of_effect.empty()) return;
  Instant at = instant_of(actuator_, state, sign_of(state.motor_speed_rad_s));
  at.current_A = circuit_.current_A(state, drive);
  at.input = commanded_Nm(at, drive);
  if (!train_.is_tight(state)) at.twist_rate_rad_s = 0.0;
  std::size_t next = 0;
  for (const Effect& effect : actuator_.effects) {
    if (effect.kind->state_rate == nullptr) continue;
    double& value = state.of_effect[next++];
    at.state = value;
    const double rate = effect.kind->state_rate(effect, at);
    // Rates are linear in their state: a difference is its slope.
    at.state = value + 1.0;
    change(value, rate, effect.kind->state_rate(effect, at) - rate);
  }
}

void JointModel::advance_states(JointState& state, const DriveNow& drive, double step_s) const {
  change_states(state, drive, [step_s](double& value, double rate, double slope) {
    value = exponential_step(value, rate, slope, step_s);
  });
}

void JointModel::settle_states(JointState& state, const DriveNow& drive) const {
  change_states(state, drive, [](double& value, double rate, double slope) {
    if (slope < 0.0) value -= rate / slope;
  });
}

void JointModel::heat(JointState& state, double current_A, double step_s) const {
  if (!heat_) return;
  const double amplitude_A =
      current_A * actuator::phase_amperes_per_ampere(actuator_.motor.torque_constant_convention);
  const Instant warm = actuator::at_winding_temperature(actuator_, state.temperature.winding_K);
  heat_->advance(state.temperature, actuator::winding_loss_W(actuator_, amplitude_A, warm), step_s);
}

double JointModel::coupling_Nm_rad() const {
  double sum_Nm_rad = train_.stiffness_Nm_rad();
  for (const Effect& effect : actuator_.effects) {
    // Bristles stand on the motor's side, which an elastic train parts from the output.
    if (is_elastic() && effect.kind->state_rate != nullptr) continue;
    sum_Nm_rad += stiffness_to_frame_Nm_rad(effect);
  }
  return sum_Nm_rad;
}

double JointModel::carried_Nm(double after_mesh_Nm, double direction) const {
  const int way = direction < 0.0 ? 1 : 0;
  return after_mesh_Nm / gain_[way][after_mesh_Nm < 0.0 ? 1 : 0];
}

}  // namespace torquewright::simulation
