// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/sampled_bench/drive_train.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::oracles::sampled {

void DriveTrain::start(double time_s, double angle_rad, double speed_rad_s, double winding_K) {
  now_ = Instant{};
  now_.time_s = time_s;
  now_.angle_rad = now_.motor_angle_rad = angle_rad;
  now_.speed_rad_s = now_.motor_speed_rad_s = speed_rad_s;
  now_.winding_K = winding_K;
  now_.case_K = kReference_K + 0.8 * (winding_K - kReference_K);
  now_.bus_V = plant_.bus_V;
}

void DriveTrain::advance_winding(const StepInput& input) {
  const double warm = 1.0 + laws_.resistance_temperature_1_K * (now_.winding_K - kReference_K);
  const double resistance = plant_.resistance_ohm * warm;
  // The speed at the step's end, as the last acceleration promises it.
  const double ahead_rad_s = now_.motor_speed_rad_s + step_s_ * now_.motor_acceleration_rad_s2;
  const double back_emf_V = constant_Nm_A(plant_, laws_, now_.winding_K) * ahead_rad_s;
  const double before_A = now_.current_A;
  if (plant_.is_voltage_driven()) {
    now_.winding_V = plant_.drive == DriveKind::kDuty ? input.command * now_.bus_V : input.command;
    const double inductive = plant_.inductance_H / step_s_;
    now_.current_A = beyond(inductive * before_A + now_.winding_V - back_emf_V, laws_.dead_time_V) /
                     (inductive + resistance);
  } else {
    now_.current_A += (input.command - before_A) * -std::expm1(-step_s_ / current_loop_s_);
    now_.winding_V = resistance * now_.current_A + back_emf_V +
                     plant_.inductance_H * (now_.current_A - before_A) / step_s_ +
                     laws_.dead_time_V * sign_of(now_.current_A);
  }
  now_.current_rate_A_s = (now_.current_A - before_A) / step_s_;
  now_.bus_V = plant_.bus_V - laws_.sag_ohm * now_.winding_V / now_.bus_V * now_.current_A;
  const double behind_A = now_.torque_current_A;
  const double follow = laws_.lag_s > 0.0 ? -std::expm1(-step_s_ / laws_.lag_s) : 1.0;
  now_.torque_current_A += (now_.current_A - behind_A) * follow;
  // The mean over the step: the mechanics then has second order in time.
  const double mean_A = 0.5 * (behind_A + now_.torque_current_A);
  const double mid_rad = now_.motor_angle_rad + 0.5 * step_s_ * now_.motor_speed_rad_s;
  before_mesh_Nm_ = magnet_torque_Nm(plant_, laws_, mean_A, now_.winding_K) +
                    sum_at(laws_.cogging, plant_.ratio * mid_rad);
}

void DriveTrain::advance_heat() {
  const Heating& heat = plant_.heating;
  const double warm = 1.0 + laws_.resistance_temperature_1_K * (now_.winding_K - kReference_K);
  const double copper_W = plant_.resistance_ohm * warm * now_.current_A * now_.current_A;
  const double to_case_W = (now_.winding_K - now_.case_K) / heat.winding_to_case_K_W;
  const double to_air_W = (now_.case_K - kReference_K) / heat.case_to_ambient_K_W;
  now_.winding_K += step_s_ * (copper_W - to_case_W) / heat.winding_J_K;
  now_.case_K += step_s_ * (to_case_W - to_air_W) / heat.case_J_K;
}

double DriveTrain::load_inertia() const {
  const Load& load = plant_.load;
  return load.inertia_kg_m2 * laws_.load_inertia_factor +
         load.mass_kg * laws_.load_mass_factor * load.length_m * load.length_m;
}

/// What the load asks for beside its acceleration, at the step's middle.
double DriveTrain::load_side_Nm(const StepInput& input) const {
  Instant middle = now_;
  middle.angle_rad += 0.5 * step_s_ * now_.speed_rad_s;
  const double gravity =
      plant_.load.gravity_Nm() * laws_.load_mass_factor * std::sin(middle.angle_rad);
  return gravity - input.brake_Nm - output_torques_Nm(laws_, middle, 0.0);
}

DriveTrain::Port DriveTrain::rigid_port(const StepInput& input) const {
  const double share = 1.0 + ripple_share_;
  const double inertia = load_inertia() / step_s_;
  return {(load_side_Nm(input) - inertia * now_.speed_rad_s) / share, inertia / share};
}

/// Twist beyond the gap.
double DriveTrain::contact_rad() const {
  return beyond(now_.motor_angle_rad - now_.angle_rad, 0.5 * laws_.gap_rad);
}

DriveTrain::Port DriveTrain::spring_port(const StepInput& input, bool in_contact) const {
  if (!in_contact) return {};
  const double kappa = step_s_ * laws_.stiffness_Nm_rad + laws_.damping_Nm_s_rad;
  const double wound = laws_.stiffness_Nm_rad * contact_rad();
  if (plant_.load.kind == LoadKind::kImposedSpeed) {
    return {wound - kappa * input.imposed_rad_s, kappa};
  }
  // The load's new speed is eliminated: (M/h + kappa) w_l = M/h w_l0 - rest + wound + kappa w_m.
  const double inertia = load_inertia() / step_s_;
  const double pull = inertia * now_.speed_rad_s - load_side_Nm(input) + wound;
  const double both = inertia + kappa;
  return {wound - kappa * pull / both, kappa - kappa * kappa / both};
}

/// Dahl's law over one step, implicit: dF = k dx (1 - F/C sgn(dx)).
double DriveTrain::bristle_after(double speed_rad_s, double level_Nm) const {
  const double stretch = laws_.presliding_Nm_rad * step_s_ * speed_rad_s;
  return (now_.bristle_Nm + stretch) / (1.0 + std::abs(stretch) / std::max(level_Nm, 1e-12));
}

/// What the mesh delivers if the motor side reaches a speed, moving towards `sign`.
double DriveTrain::mesh_torque(double speed_rad_s, double sign) const {
  const double middle = 0.5 * (now_.motor_speed_rad_s + speed_rad_s);
  const double level = dry_friction_Nm(laws_, now_, middle, sign);
  const double dry =
      laws_.presliding_Nm_rad > 0.0 ? bristle_after(speed_rad_s, level) : sign * level;
  const double inertia = plant_.armature_kg_m2() + laws_.inertia_kg_m2;
  const double before = before_mesh_Nm_ - dry - wet_friction_Nm(laws_, now_, middle) -
                        inertia * (speed_rad_s - now_.motor_speed_rad_s) / step_s_;
  return through_mesh_Nm(plant_, laws_, before, sign);
}

/// The speed at which the mesh delivers what the port asks for; the difference grows with the speed
/// and jumps at rest.
double DriveTrain::solve_speed(const Port& port) const {
  const double forwards = port.constant - mesh_torque(0.0, 1.0);
  const double backwards = port.constant - mesh_torque(0.0, -1.0);
  if (forwards >= 0.0 && backwards <= 0.0) return 0.0;
  const double sign = forwards < 0.0 ? 1.0 : -1.0;
  double last = 0.0;
  double last_excess = sign > 0.0 ? forwards : backwards;
  const double inertia = (plant_.armature_kg_m2() + laws_.inertia_kg_m2) / step_s_;
  double speed = -last_excess / (port.slope + inertia);
  for (int pass = 0; pass < 8 && speed != last; ++pass) {
    const double excess = port.constant + port.slope * speed - mesh_torque(speed, sign);
    const double slope = (excess - last_excess) / (speed - last);
    if (!(slope > 0.0)) break;
    last = speed;
    last_excess = excess;
    speed = speed - excess / slope;
    if (std::abs(speed - last) < 1e-13 * (1.0 + std::abs(speed))) break;
  }
  return sign * std::max(0.0, sign * speed);
}

/// At an imposed speed the torque jumps where the speed passes zero; the jump is spread over a
/// thousandth of the speeds used.
double DriveTrain::imposed_mesh_torque(double speed_rad_s) const {
  const double sign = std::clamp(speed_rad_s / (1e-3 * plant_.used_speed_rad_s), -1.0, 1.0);
  return 0.5 * (1.0 + sign) * mesh_torque(speed_rad_s, 1.0) +
         0.5 * (1.0 - sign) * mesh_torque(speed_rad_s, -1.0);
}

void DriveTrain::advance_rigid(const StepInput& input) {
  const bool imposed = plant_.load.kind == LoadKind::kImposedSpeed;
  const Port port = imposed ? Port{} : rigid_port(input);
  const double speed = imposed ? input.imposed_rad_s : solve_speed(port);
  const double mesh = imposed ? imposed_mesh_torque(speed) : port.constant + port.slope * speed;
  finish(speed, speed, mesh, input);
}

void DriveTrain::advance_two_mass(const StepInput& input) {
  const bool touching = laws_.gap_rad == 0.0 || contact_rad() != 0.0;
  Port port = spring_port(input, touching);
  double motor_speed = solve_speed(port);
  double mesh = port.constant + port.slope * motor_speed;
  if (laws_.gap_rad > 0.0 && mesh * contact_rad() < 0.0) {  // teeth do not pull
    port = {};
    motor_speed = solve_speed(port);
    mesh = 0.0;
  }
  const double load_speed =
      plant_.load.kind == LoadKind::kImposedSpeed
          ? input.imposed_rad_s
          : now_.speed_rad_s + step_s_ * (mesh - load_side_Nm(input)) / load_inertia();
  finish(motor_speed, load_speed, mesh, input);
}

void DriveTrain::finish(double motor_speed, double load_speed, double mesh_Nm,
                        const StepInput& input) {
  const double middle = 0.5 * (now_.motor_speed_rad_s + motor_speed);
  const double level = dry_friction_Nm(laws_, now_, middle, sign_of(motor_speed));
  now_.bristle_Nm = bristle_after(motor_speed, level);
  const double turned = 0.5 * step_s_ * (now_.speed_rad_s + load_speed);
  Instant mid = now_;
  mid.angle_rad += 0.5 * turned;
  now_.torque_Nm = mesh_Nm + output_torques_Nm(laws_, mid, mesh_Nm);
  if (laws_.odd.hysteresis_Nm > 0.0) {
    const double stretch = turned * laws_.odd.hysteresis_Nm / laws_.odd.hysteresis_rad;
    now_.hysteresis_Nm =
        (now_.hysteresis_Nm + stretch) / (1.0 + std::abs(stretch) / laws_.odd.hysteresis_Nm);
  }
  const double slip = 1.0 + laws_.odd.slip_per_Nm * mesh_Nm;
  // A rigid train keeps the two angles equal to the last digit.
  const double motor_turned = step_s_ * middle * slip;
  now_.motor_angle_rad += laws_.is_two_mass() ? step_s_ * motor_speed : motor_turned;
  now_.angle_rad += laws_.is_two_mass() ? step_s_ * load_speed : turned;
  now_.acceleration_rad_s2 = (load_speed - now_.speed_rad_s) / step_s_;
  now_.motor_acceleration_rad_s2 = (motor_speed - now_.motor_speed_rad_s) / step_s_;
  now_.speed_rad_s = load_speed;
  now_.motor_speed_rad_s = motor_speed;
  now_.brake_Nm = input.brake_Nm;
  now_.time_s += step_s_;
}

void DriveTrain::advance(const StepInput& input) {
  advance_winding(input);
  advance_heat();
  ripple_share_ =
      sum_at(laws_.proportional_ripple, now_.angle_rad + 0.5 * step_s_ * now_.speed_rad_s);
  if (laws_.is_two_mass()) {
    advance_two_mass(input);
  } else {
    advance_rigid(input);
  }
}

}  // namespace torquewright::oracles::sampled
