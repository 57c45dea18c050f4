// SPDX-License-Identifier: Apache-2.0
// The three kinds of step: imposed motion, one inertia, two inertias.
#include <algorithm>
#include <cmath>

#include "tests/oracles/bench_log/simulation.hpp"

namespace torquewright::oracles {
void Simulation::imposed_rigid_step(std::size_t knot, double from, double to) {
  const double step_s = (to - from) * kTick_s;
  const ImposedMotion::Point point = imposed_.at(knot, to);
  const double moved = point.position_rad - q_;
  q_ = qm_ = point.position_rad;
  w_ = wm_ = point.speed_rad_s;
  a_ = point.acceleration_rad_s2;
  double current_A = current_A_ + to * (next_current_A_ - current_A_);
  double torque = motor_torque_Nm(machine_, current_A, winding_K_);
  if (machine_.lag_s > 0.0) {
    const double middle_A = current_A_ + 0.5 * (from + to) * (next_current_A_ - current_A_);
    lagged_Nm_ += (motor_torque_Nm(machine_, middle_A, winding_K_) - lagged_Nm_) *
                  -std::expm1(-step_s / machine_.lag_s);
    torque = lagged_Nm_;
  }
  const double direction = sign_of(w_);
  slip(moved, direction);
  const double net = torque + rotor_ripple_Nm(qm_, wm_, torque) -
                     machine_.motor_inertia_kg_m2() * a_ - bristle_Nm_;
  const double gain = 1.0 + machine_.load_ripple.at(q_);
  const double ripple = output_ripple_Nm(q_);
  const auto moving = [&](double way) {
    const double friction = friction_Nm(machine_, situation(q_, w_), way);
    return gain * way * through_gear_Nm(machine_, way * net - friction) + ripple;
  };
  // At rest the drive holds whatever lies between what it gives to either side.
  torque_Nm_ = direction != 0.0 ? moving(direction)
                                : std::clamp(torque_Nm_, std::min(moving(1.0), moving(-1.0)),
                                             std::max(moving(1.0), moving(-1.0)));
}

double Simulation::rigid_acceleration(double rad, double rad_s, double direction,
                                      const Drive& drive, double* friction, double* on_load) const {
  const double torque = drive.torque_Nm + rotor_ripple_Nm(rad, rad_s, drive.torque_Nm);
  *friction = friction_Nm(machine_, situation(rad, rad_s), direction) + direction * bristle_Nm_;
  const double net = direction * torque - *friction;
  const double load = direction * (load_Nm(rad) - output_ripple_Nm(rad));
  const double gain = 1.0 + machine_.load_ripple.at(rad);
  const double motor = machine_.motor_inertia_kg_m2();
  // J a + load = gain slope (net - Jm a), with the slope of driving or of being driven: the torque
  // through the gear is monotone in the acceleration, so exactly one of them fits.
  const auto solve = [&](double slope) {
    return (gain * slope * net - load) / (machine_.load.inertia_kg_m2 + gain * slope * motor);
  };
  const double driving = solve(through_gear_Nm(machine_, 1.0));
  const bool is_driving = net - motor * driving > 0.0;
  const double forward = is_driving ? driving : solve(-through_gear_Nm(machine_, -1.0));
  *on_load = direction * (machine_.load.inertia_kg_m2 * forward + load) + output_ripple_Nm(rad);
  return direction * forward;
}

int Simulation::rigid_start(const Drive& drive) const {
  double friction = 0.0;
  double on_load = 0.0;
  if (rigid_acceleration(q_, 0.0, 1.0, drive, &friction, &on_load) > 0.0) return 1;
  if (rigid_acceleration(q_, 0.0, -1.0, drive, &friction, &on_load) < 0.0) return -1;
  return 0;
}

void Simulation::rigid_step(double step_s, const Drive& drive) {
  double left_s = step_s;
  // A step may hold a stop and a new start; more than a few of them are a rest.
  for (int part = 0; part < 4 && left_s > 0.0; ++part) {
    const double direction = w_ != 0.0 ? sign_of(w_) : rigid_start(drive);
    if (direction == 0.0) {
      a_ = 0.0;
      torque_Nm_ = load_Nm(q_);
      break;
    }
    double middle_w = w_ + 0.5 * left_s * a_;
    if (direction * middle_w < 0.0) middle_w = 0.0;
    const double middle_q = q_ + 0.5 * left_s * 0.5 * (w_ + middle_w);
    double friction = 0.0;
    double on_load = 0.0;
    const double a = rigid_acceleration(middle_q, middle_w, direction, drive, &friction, &on_load);
    double end_w = w_ + left_s * a;
    double part_s = left_s;
    const bool stops = direction * end_w < 0.0;
    if (stops) {
      part_s = std::min(left_s, -w_ / a);
      end_w = 0.0;
    }
    const double moved = 0.5 * (w_ + end_w) * part_s;
    const double torque = drive.torque_Nm + rotor_ripple_Nm(middle_q, middle_w, drive.torque_Nm);
    account_.motor_J += torque * moved;
    account_.friction_J += direction * friction * moved;
    account_.gear_J += (torque - direction * friction - machine_.motor_inertia_kg_m2() * a -
                        (on_load - output_ripple_Nm(middle_q))) *
                       moved;
    q_ += moved;
    w_ = end_w;
    a_ = stops ? 0.0 : a;
    torque_Nm_ = on_load;
    slip(moved, direction);
    left_s -= part_s;
  }
  qm_ = q_;
  wm_ = w_;
}

double Simulation::spring_Nm(double twist_rad, double twist_rad_s) const {
  const double half = 0.5 * machine_.gap_rad;
  if (std::abs(twist_rad) <= half && machine_.gap_rad > 0.0) return 0.0;
  const double side = sign_of(twist_rad);
  const double torque =
      contact_Nm_rad_ * (twist_rad - side * half) + contact_Nm_s_rad_ * twist_rad_s;
  // Flanks push, they do not pull.
  return machine_.gap_rad > 0.0 && torque * side < 0.0 ? 0.0 : torque;
}

double Simulation::motor_kick(double step_s, double rad, double spring, const Drive& drive) {
  const double torque = drive.torque_Nm + rotor_ripple_Nm(rad, wm_, drive.torque_Nm);
  const auto acceleration = [&](double way) {
    const double friction = friction_Nm(machine_, situation(rad, wm_), way) + way * bristle_Nm_;
    const double carried = before_gear_Nm(machine_, way * spring);
    return way * (way * torque - friction - carried) / machine_.motor_inertia_kg_m2();
  };
  double direction = sign_of(wm_);
  if (direction == 0.0 && acceleration(1.0) > 0.0) direction = 1.0;
  if (direction == 0.0 && acceleration(-1.0) < 0.0) direction = -1.0;
  if (direction == 0.0) return 0.0;
  const double speed = wm_ + step_s * acceleration(direction);
  return speed * direction < 0.0 ? 0.0 : speed;
}

// Half a step of motion, a kick, half a step of motion: keeps the energy of a spring.
void Simulation::two_mass_step(std::size_t knot, double from, double to, const Drive& drive) {
  const double step_s = (to - from) * kTick_s;
  const double middle_qm = qm_ + 0.5 * step_s * wm_;
  const ImposedMotion::Point middle = is_imposed()
                                          ? imposed_.at(knot, 0.5 * (from + to))
                                          : ImposedMotion::Point{q_ + 0.5 * step_s * w_, w_, a_};
  const double spring = spring_Nm(middle_qm - middle.position_rad, wm_ - middle.speed_rad_s);
  const double before = wm_;
  wm_ = motor_kick(step_s, middle_qm, spring, drive);
  const double moved = 0.5 * step_s * (before + wm_);
  qm_ += moved;
  slip(moved, sign_of(moved));
  const double gain = 1.0 + machine_.load_ripple.at(middle.position_rad);
  torque_Nm_ = gain * spring + output_ripple_Nm(middle.position_rad);
  if (is_imposed()) {
    const ImposedMotion::Point point = imposed_.at(knot, to);
    q_ = point.position_rad;
    w_ = point.speed_rad_s;
    a_ = point.acceleration_rad_s2;
    return;
  }
  a_ = (torque_Nm_ - load_Nm(middle.position_rad)) / machine_.load.inertia_kg_m2;
  w_ += step_s * a_;
  q_ = middle.position_rad + 0.5 * step_s * w_;
}

}  // namespace torquewright::oracles
