// SPDX-License-Identifier: Apache-2.0
#include "identification/joint_model.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/region/gear_losses.hpp"
#include "actuator/region/torque_at.hpp"

namespace torquewright::identification {
namespace {

using actuator::Effect;
using actuator::Instant;

// Flanks of a gap without a stated stiffness meet at this frequency, nearly critically damped:
// above what logs of 1 kHz resolve, and slow enough for steps of 0.1 ms.
constexpr double kContact_rad_s = 1000.0;
constexpr double kContactDamping = 0.6;
// Steps per radian of the fastest oscillation. A twist that is hardly damped keeps its phase over
// hundreds of radians only with many; a well damped contact needs few.
constexpr double kBristleSteps = 10.0;
constexpr double kTwistSteps = 200.0;
constexpr double kContactSteps = 10.0;

const Effect* find(const actuator::Actuator& actuator, std::string_view name) {
  for (const Effect& effect : actuator.effects) {
    if (effect.kind->name == name) return &effect;
  }
  return nullptr;
}

/// x(h) of dx/dt = rate + slope (x - x0).
double exponential_step(double state, double rate, double slope, double step_s) {
  const double z = slope * step_s;
  const double phi = std::abs(z) < 1e-8 ? 1.0 + 0.5 * z : std::expm1(z) / z;
  return state + step_s * phi * rate;
}

double bristle_rad_s(const actuator::Actuator& actuator, double inertia_kg_m2) {
  double stiffness_Nm_rad = 0.0;
  for (const Effect& effect : actuator.effects) {
    if (effect.kind->name == "presliding_friction" && effect.values[0] > 0.0 &&
        std::isfinite(effect.values[1])) {
      stiffness_Nm_rad += effect.values[1];
    }
  }
  return inertia_kg_m2 > 0.0 ? std::sqrt(stiffness_Nm_rad / inertia_kg_m2) : 0.0;
}

}  // namespace

JointModel::JointModel(const actuator::Actuator& actuator, double load_inertia_kg_m2,
                       const SimulationOptions& options)
    : actuator_(actuator),
      winding_(winding_of(actuator)),
      inertia_kg_m2_(actuator::reflected_inertia_kg_m2(actuator)) {
  const Effect* gap = find(actuator, "backlash");
  if (gap != nullptr && gap->values[0] > 0.0) gap_ = gap;
  const Effect* spring = find(actuator, "torsional_compliance");
  if (spring != nullptr && std::isfinite(spring->values[0])) spring_ = spring;
  is_elastic_ = (gap_ != nullptr || spring_ != nullptr) && inertia_kg_m2_ > 0.0;
  contact_Nm_rad_ = inertia_kg_m2_ * kContact_rad_s * kContact_rad_s;
  contact_Nm_s_rad_ = 2.0 * kContactDamping * kContact_rad_s * inertia_kg_m2_;
  if (options.inductance) {
    const auto convention = actuator.motor.torque_constant_convention;
    inductance_H_ = actuator.motor.inductance_q_H * actuator::phase_amperes_per_ampere(convention) /
                    actuator::phase_volts_per_winding_volt(convention);
  }
  for (int way = 0; way < 2; ++way) {
    const double direction = way == 0 ? 1.0 : -1.0;
    gain_[way][0] = actuator::after_mesh_Nm(actuator, 1.0, direction);
    gain_[way][1] = -actuator::after_mesh_Nm(actuator, -1.0, direction);
  }
  longest_step_s_ = options.longest_step_s;
  const auto limit = [this](double rate_rad_s, double steps) {
    if (rate_rad_s > 0.0) longest_step_s_ = std::min(longest_step_s_, 1.0 / (steps * rate_rad_s));
  };
  limit(bristle_rad_s(actuator, inertia_kg_m2_ + (is_elastic_ ? 0.0 : load_inertia_kg_m2)),
        kBristleSteps);
  if (!is_elastic_) return;
  const double load = load_inertia_kg_m2 > 0.0 ? 1.0 / load_inertia_kg_m2 : 0.0;
  const double stiffness = spring_ != nullptr ? spring_->values[0] : contact_Nm_rad_;
  const double damping = spring_ != nullptr ? spring_->values[1] : contact_Nm_s_rad_;
  limit(std::sqrt(stiffness * (1.0 / inertia_kg_m2_ + load)),
        spring_ != nullptr ? kTwistSteps : kContactSteps);
  limit(damping * (1.0 / inertia_kg_m2_ + load), kContactSteps);
}

JointState JointModel::initial(const JointStart& start) const {
  JointState state;
  state.position_rad = state.motor_position_rad = start.position_rad;
  state.speed_rad_s = state.motor_speed_rad_s = start.speed_rad_s;
  if (is_elastic_) state.motor_position_rad += start.motor_ahead_rad;
  const double reference_K = actuator_.motor.winding_temperature_K;
  const double ambient_K = actuator_.thermal ? actuator_.thermal->ambient_K : reference_K;
  state.winding_K = start.winding_K.value_or(actuator_.thermal ? ambient_K : reference_K);
  state.case_K = start.case_K.value_or(ambient_K);
  for (const Effect& effect : actuator_.effects) {
    if (effect.kind->state_rate != nullptr) state.of_effect.push_back(0.0);
  }
  return state;
}

Instant JointModel::instant(const JointState& state, double direction) const {
  Instant at;
  at.speed_rad_s = state.motor_speed_rad_s;
  at.direction = direction;
  at.output_angle_rad = state.position_rad;
  at.motor_angle_rad = ratio() * state.motor_position_rad;
  at.winding_temperature_K = state.winding_K;
  at.reference_temperature_K = actuator_.motor.winding_temperature_K;
  at.twist_rad = state.motor_position_rad - state.position_rad;
  at.twist_rate_rad_s = state.motor_speed_rad_s - state.speed_rad_s;
  return at;
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
    if (effect.kind->name == "torque_lag") {
      // A time constant of zero follows at once.
      if (effect.values[0] > 0.0) *motor_Nm += torque_Nm;
    } else {
      friction_Nm += drag_factor * torque_Nm;
    }
  }
  return friction_Nm;
}

JointForces JointModel::forces(const JointState& state, double direction,
                               const DriveNow& drive) const {
  Instant at = instant(state, direction);
  JointForces forces;
  forces.current_A = at.current_A = current_A(state, drive);
  forces.motor_Nm = actuator::motor_torque_Nm(actuator_, at);
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
  if (inductance_H_ > 0.0 && drive.kind >= DriveKind::kVoltage) {
    const Instant at = instant(state, sign_of(state.motor_speed_rad_s));
    const double resistance = resistance_ohm(actuator_, winding_, at);
    // L di/dt = R (i that the voltage would drive in the long run - i).
    const double bus = bus_V(state, drive, state.current_A);
    const double settled_A = quasi_static_A(state, drive, bus);
    const double slope = -resistance / inductance_H_;
    change(state.current_A, slope * (state.current_A - settled_A), slope);
  }
  if (state.of_effect.empty()) return;
  Instant at = instant(state, sign_of(state.motor_speed_rad_s));
  at.current_A = current_A(state, drive);
  at.input = actuator::motor_torque_Nm(actuator_, at);
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
  if (!actuator_.thermal) return;
  const actuator::Thermal& thermal = *actuator_.thermal;
  const auto& motor = actuator_.motor;
  const double amplitude_A =
      current_A * actuator::phase_amperes_per_ampere(motor.torque_constant_convention);
  const double phase_ohm =
      motor.resistance_ohm * actuator::phase_ohms_per_ohm(motor.resistance_convention);
  const double warm =
      resistance_ohm(actuator_, winding_, instant(state, 0.0)) / winding_.resistance_ohm;
  const double loss_W = 1.5 * phase_ohm * warm * amplitude_A * amplitude_A;
  // Midpoint rule: time constants are seconds, steps milliseconds at most.
  double winding_K = state.winding_K;
  double case_K = state.case_K;
  double winding_K_s = 0.0;
  double case_K_s = 0.0;
  for (int stage = 0; stage < 2; ++stage) {
    const double inner_W = (winding_K - case_K) / thermal.winding_to_case_K_W;
    const double outer_W = (case_K - thermal.ambient_K) / thermal.case_to_ambient_K_W;
    winding_K_s = (loss_W - inner_W) / thermal.winding_J_K;
    case_K_s = (inner_W - outer_W) / thermal.case_J_K;
    winding_K = state.winding_K + 0.5 * step_s * winding_K_s;
    case_K = state.case_K + 0.5 * step_s * case_K_s;
  }
  state.winding_K += step_s * winding_K_s;
  state.case_K += step_s * case_K_s;
}

double JointModel::applied_V(const JointState& state, const DriveNow& drive, double bus_V) const {
  if (drive.kind == DriveKind::kVoltage) return drive.value;
  const double duty = drive.kind == DriveKind::kDuty
                          ? drive.value
                          : drive.position_gain_1_rad * (drive.value - state.position_rad);
  return std::clamp(duty, -1.0, 1.0) * bus_V;
}

double JointModel::quasi_static_A(const JointState& state, const DriveNow& drive,
                                  double bus_V) const {
  Instant at = instant(state, 0.0);
  const double back_emf_V = winding_.back_emf_V_s_rad * actuator::flux_factor(actuator_, at) *
                            ratio() * state.motor_speed_rad_s;
  const double left_V = applied_V(state, drive, bus_V) - back_emf_V;
  const double resistance = resistance_ohm(actuator_, winding_, at);
  // What the bridge loses opposes the current; where it exceeds what is left, none flows.
  at.current_A = sign_of(left_V);
  const double driving_V = left_V + actuator::winding_voltage_change_V(actuator_, at);
  return driving_V * at.current_A > 0.0 ? driving_V / resistance : 0.0;
}

double JointModel::bus_V(const JointState& state, const DriveNow& drive, double current_A) const {
  if (drive.bus_V) return *drive.bus_V;
  const double open_V = actuator_.drive.bus_voltage_V;
  const double volts = voltage_V(state, drive, current_A);
  Instant at = instant(state, 0.0);
  // Bus current = duty times winding current, duty = volts over the bus voltage: a few rounds.
  double bus = open_V;
  for (int round = 0; round < 4; ++round) {
    const double duty = drive.kind == DriveKind::kDuty ? drive.value : volts / bus;
    at.bus_current_A = duty * current_A;
    bus = std::max(0.1 * open_V, open_V + actuator::bus_voltage_change_V(actuator_, at));
  }
  return bus;
}

double JointModel::current_A(const JointState& state, const DriveNow& drive) const {
  switch (drive.kind) {
    case DriveKind::kCurrent:
      return drive.value;
    case DriveKind::kTorque:
      return drive.value / (ratio() * actuator_.motor.torque_constant_Nm_A);
    default:
      break;
  }
  if (inductance_H_ > 0.0) return state.current_A;
  const double open_V = drive.bus_V.value_or(actuator_.drive.bus_voltage_V);
  const double first_A = quasi_static_A(state, drive, open_V);
  if (drive.bus_V || drive.kind == DriveKind::kVoltage) return first_A;
  // The bus falls with the current, the current with the bus: affine, so one step of Aitken's.
  const double second_A = quasi_static_A(state, drive, bus_V(state, drive, first_A));
  const double third_A = quasi_static_A(state, drive, bus_V(state, drive, second_A));
  const double curve_A = third_A - 2.0 * second_A + first_A;
  return curve_A == 0.0 ? third_A : first_A - (second_A - first_A) * (second_A - first_A) / curve_A;
}

double JointModel::voltage_V(const JointState& state, const DriveNow& drive,
                             double current_A) const {
  if (drive.kind == DriveKind::kVoltage) return drive.value;
  Instant at = instant(state, 0.0);
  at.current_A = current_A;
  return resistance_ohm(actuator_, winding_, at) * current_A +
         winding_.back_emf_V_s_rad * actuator::flux_factor(actuator_, at) * ratio() *
             state.motor_speed_rad_s -
         actuator::winding_voltage_change_V(actuator_, at);
}

JointModel::Twist JointModel::twist(const JointState& state) const {
  Instant at = instant(state, 0.0);
  if (gap_ != nullptr) at.twist_rad = gap_->kind->law(*gap_, at);
  if (gap_ != nullptr && at.twist_rad == 0.0) return {};
  Twist twist;
  if (spring_ != nullptr) {
    twist.damping_Nm = spring_->values[1] * at.twist_rate_rad_s;
    twist.torque_Nm = spring_->kind->law(*spring_, at);
    twist.stored_J = 0.5 * (twist.torque_Nm - twist.damping_Nm) * at.twist_rad;
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

double JointModel::carried_Nm(double after_mesh_Nm, double direction) const {
  const int way = direction < 0.0 ? 1 : 0;
  return after_mesh_Nm / gain_[way][after_mesh_Nm < 0.0 ? 1 : 0];
}

}  // namespace torquewright::identification
