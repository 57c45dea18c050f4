// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/bench_log/simulation.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::oracles {
namespace {

// Where no stiffness is stated the flanks of a gap meet at this frequency, well damped. The truth's
// table knows no compliance then, so the log must not show one: under the peak torque of a drawn
// drive (up to 2000 times its reflected inertia per s^2) they give way by 1e-4 rad, a fortieth of
// the least gap; at 800 rad/s it was the gap's half.
constexpr double kContact_rad_s = 4000.0;
constexpr double kContactDamping = 0.5;

}  // namespace

Simulation::Simulation(const Machine& machine, const RunPlan& plan)
    : machine_(machine),
      plan_(plan),
      imposed_(plan.speed_rad_s.empty() ? Knots(plan.knot_count(), 0.0) : plan.speed_rad_s,
               plan.start_rad),
      q_(plan.start_rad),
      w_(plan.start_rad_s),
      qm_(plan.start_rad),
      wm_(plan.start_rad_s),
      winding_K_(plan.winding_K),
      case_K_(plan.case_K) {
  const double inertia = machine.motor_inertia_kg_m2();
  const bool is_stated = machine.stiffness_Nm_rad < kInfinity;
  contact_Nm_rad_ =
      is_stated ? machine.stiffness_Nm_rad : inertia * kContact_rad_s * kContact_rad_s;
  contact_Nm_s_rad_ =
      is_stated ? machine.damping_Nm_s_rad : 2.0 * kContactDamping * kContact_rad_s * inertia;
  if (is_imposed()) {
    w_ = imposed_.at(0, 0.0).speed_rad_s;
    a_ = imposed_.at(0, 0.0).acceleration_rad_s2;
    wm_ = w_;
  }
  last_direction_ = sign_of(wm_);
  if (!plan.current_A.empty()) current_A_ = next_current_A_ = plan.current_A[0];
  if (!plan.voltage_V.empty()) {
    voltage_V_ = next_voltage_V_ = plan.voltage_V[0];
    current_A_ = current_from_voltage_A(machine_, voltage_V_, machine_.ratio * wm_, winding_K_);
  }
  lagged_Nm_ = motor_torque_Nm(machine_, current_A_, winding_K_);
  start_stored_J_ = stored_J();
  if (is_imposed() && !machine_.has_two_positions()) imposed_rigid_step(0, 0.0, 0.0);
}

void Simulation::aim(std::size_t next_knot) {
  if (!plan_.voltage_V.empty()) {
    next_voltage_V_ = std::clamp(plan_.voltage_V[next_knot], -machine_.bus_V, machine_.bus_V);
    return;
  }
  double current_A = plan_.current_A.empty() ? 0.0 : plan_.current_A[next_knot];
  if (!plan_.position_rad.empty()) {
    const double speed =
        (plan_.position_rad[next_knot] - plan_.position_rad[next_knot - 1]) / kTick_s;
    const double torque = plan_.controller_Nm_rad * (plan_.position_rad[next_knot] - q_) +
                          plan_.controller_Nm_s_rad * (speed - w_);
    current_A += torque / (machine_.ratio * machine_.torque_constant_Nm_A);
  }
  next_current_A_ = std::clamp(current_A, -machine_.peak_current_A, machine_.peak_current_A);
}

Simulation::Drive Simulation::drive_at(double share, double step_s) {
  double current_A = current_A_ + share * (next_current_A_ - current_A_);
  if (!plan_.voltage_V.empty()) {
    const double voltage_V = voltage_V_ + share * (next_voltage_V_ - voltage_V_);
    current_A = current_from_voltage_A(machine_, voltage_V, machine_.ratio * wm_, winding_K_);
  }
  double torque = motor_torque_Nm(machine_, current_A, winding_K_);
  if (machine_.lag_s > 0.0) {
    // Exact for a torque that is constant over the step; its middle is taken.
    const double before = lagged_Nm_;
    lagged_Nm_ += (torque - lagged_Nm_) * -std::expm1(-step_s / machine_.lag_s);
    torque = 0.5 * (before + lagged_Nm_);
  }
  return {torque, current_A};
}

double Simulation::rotor_ripple_Nm(double motor_rad, double motor_rad_s, double torque_Nm) const {
  double sum = 0.0;
  const double angle = machine_.ratio * motor_rad;
  if (!machine_.cogging.terms.empty()) {
    const double fade = std::exp(-std::abs(motor_rad_s) / machine_.outside.cogging_fade_rad_s);
    sum += machine_.cogging.at(angle) * fade;
  }
  if (machine_.outside.commutation_ratio != 0.0) {
    sum += torque_Nm * machine_.outside.commutation_ratio *
           std::cos(6.0 * machine_.pole_pairs * angle + machine_.outside.commutation_phase_rad);
  }
  return sum;
}

double Simulation::output_ripple_Nm(double rad) const { return machine_.ripple.at(rad); }

double Simulation::load_Nm(double rad) const {
  double torque = 0.0;
  if (machine_.load.gravity_Nm != 0.0) torque += machine_.load.gravity_Nm * std::sin(rad);
  if (machine_.load.imbalance_Nm != 0.0) {
    torque -= machine_.load.imbalance_Nm * std::sin(rad + machine_.load.imbalance_phase_rad);
  }
  return torque;
}

Situation Simulation::situation(double rad, double rad_s) const {
  return {rad, rad_s, winding_K_, time_s_, since_reversal_s_};
}

void Simulation::slip(double moved_rad, double direction) {
  if (direction != 0.0 && direction != last_direction_) {
    since_reversal_s_ = 0.0;
    last_direction_ = direction;
  }
  const Friction& law = machine_.friction;
  if (law.presliding_Nm_rad == kInfinity || moved_rad == 0.0) return;
  const double way = moved_rad > 0.0 ? 1.0 : -1.0;
  const double warm = 1.0 + law.coefficient_1_K * (winding_K_ - machine_.reference_K);
  const double level = (way > 0.0 ? law.coulomb_positive_Nm : law.coulomb_negative_Nm) * warm * way;
  // Dahl: dF/dx = stiffness (1 - F/level), exactly over the distance moved.
  bristle_Nm_ = level + (bristle_Nm_ - level) *
                            std::exp(-law.presliding_Nm_rad * std::abs(moved_rad / level));
}

void Simulation::heat(double step_s) {
  const double resistance = machine_.resistance_ohm *
                            (1.0 + machine_.resistance_1_K * (winding_K_ - machine_.reference_K));
  const double copper_W = resistance * current_A_ * current_A_;
  const double to_case_W = (winding_K_ - case_K_) / machine_.winding_to_case_K_W;
  const double out_W = (case_K_ - machine_.ambient_K) / machine_.case_to_ambient_K_W;
  winding_K_ += step_s * (copper_W - to_case_W) / machine_.winding_J_K;
  case_K_ += step_s * (to_case_W - out_W) / machine_.case_J_K;
}

void Simulation::tick(std::size_t knot, int substeps) {
  const double step_s = kTick_s / substeps;
  const bool has_two = machine_.has_two_positions();
  for (int step = 0; step < substeps; ++step) {
    const double from = static_cast<double>(step) / substeps;
    const double to = static_cast<double>(step + 1) / substeps;
    if (is_imposed() && !has_two) {
      imposed_rigid_step(knot, from, to);
    } else if (has_two) {
      two_mass_step(knot, from, to, drive_at(0.5 * (from + to), step_s));
    } else {
      rigid_step(step_s, drive_at(0.5 * (from + to), step_s));
    }
    time_s_ += step_s;
    since_reversal_s_ += step_s;
  }
  current_A_ = next_current_A_;
  voltage_V_ = next_voltage_V_;
  if (!plan_.voltage_V.empty()) {
    current_A_ = current_from_voltage_A(machine_, voltage_V_, machine_.ratio * wm_, winding_K_);
  }
  heat(kTick_s);
}

void Simulation::record(Trace& trace) const {
  trace.position_rad.push_back(q_);
  trace.speed_rad_s.push_back(w_);
  trace.acceleration_rad_s2.push_back(a_);
  trace.motor_position_rad.push_back(machine_.ratio * qm_);
  trace.motor_speed_rad_s.push_back(machine_.ratio * wm_);
  trace.current_A.push_back(current_A_);
  trace.torque_Nm.push_back(torque_Nm_);
  const double voltage_V =
      plan_.voltage_V.empty()
          ? winding_voltage_V(machine_, current_A_, machine_.ratio * wm_, winding_K_)
          : voltage_V_;
  trace.voltage_V.push_back(voltage_V);
  trace.bus_V.push_back(bus_voltage_V(machine_, voltage_V, current_A_));
  trace.winding_K.push_back(winding_K_);
  trace.case_K.push_back(case_K_);
}

double Simulation::stored_J() const {
  const double motor = 0.5 * machine_.motor_inertia_kg_m2() * wm_ * wm_;
  const double load = 0.5 * machine_.load.inertia_kg_m2 * w_ * w_;
  const double height = machine_.load.gravity_Nm * (1.0 - std::cos(q_));
  double spring = 0.0;
  if (machine_.has_two_positions()) {
    const double wound = std::max(0.0, std::abs(qm_ - q_) - 0.5 * machine_.gap_rad);
    spring = 0.5 * contact_Nm_rad_ * wound * wound;
  }
  return motor + load + height + spring;
}

EnergyAccount Simulation::account() const {
  EnergyAccount whole = account_;
  whole.stored_J = stored_J() - start_stored_J_;
  return whole;
}

}  // namespace torquewright::oracles
