// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/oracles/sampled_bench/plant.hpp"

namespace torquewright::oracles::sampled {

struct Harmonic {
  double order = 1.0;
  double amplitude = 0.0;
  double phase_rad = 0.0;
};

inline double sign_of(double value) { return value > 0.0 ? 1.0 : (value < 0.0 ? -1.0 : 0.0); }
/// The root of x + limit sgn(x) = pull, sgn(0) being anything from -1 to 1.
inline double beyond(double pull, double limit) {
  return sign_of(pull) * std::max(0.0, std::abs(pull) - limit);
}
double sum_at(const std::vector<Harmonic>& harmonics, double angle_rad);

/// What a library of effects does not know. Neutral as constructed.
struct Oddities {
  double spring_Nm_rad = 0.0;  ///< Parallel to the actuator.
  double spring_rest_rad = 0.0;
  double stop_Nm_rad = 0.0;  ///< Elastic stop at an output angle.
  double stop_rad = 0.0;
  double friction_growth_1_s = 0.0;  ///< All dry friction, with the time since the log began.
  double iron_loss_Nm_A2 = 0.0;      ///< Drag that grows with the current squared.
  double lubrication_Nm = 0.0;       ///< Dry friction c exp(-|torque|/this): falls with load.
  double hysteresis_Nm = 0.0;        ///< Of a flexspline: rate-independent, at the output.
  double hysteresis_rad = 1.0;       ///< Angle over which it turns over.
  double slip_per_Nm = 0.0;          ///< A belt creeps: share of the speed per torque.
};

/// Everything that acts in the machine beyond what `Plant` says. Neutral as constructed.
struct Laws {
  double coulomb_positive_Nm = 0.0;
  double coulomb_negative_Nm = 0.0;
  double viscous_positive_Nm_s_rad = 0.0;
  double viscous_negative_Nm_s_rad = 0.0;
  double breakaway_excess_Nm = 0.0;
  double stribeck_velocity_rad_s = 1.0;
  double quadratic_Nm_s2_rad2 = 0.0;
  double presliding_Nm_rad = 0.0;  ///< 0: dry friction is rigid.
  double friction_temperature_1_K = 0.0;
  std::vector<Harmonic> tight_spots;
  double driving_coefficient = 0.0;
  double backdriving_coefficient = 0.0;
  double constant_factor = 1.0;
  double constant_temperature_1_K = 0.0;
  double saturation_current_A = 0.0;  ///< 0: never.
  double saturation_exponent = 2.0;
  std::vector<Harmonic> cogging;
  std::vector<Harmonic> ripple;
  std::vector<Harmonic> proportional_ripple;
  Harmonic imbalance;
  double inertia_kg_m2 = 0.0;
  double gap_rad = 0.0;
  double stiffness_Nm_rad = 0.0;  ///< 0: rigid.
  double damping_Nm_s_rad = 0.0;
  double lag_s = 0.0;
  double sag_ohm = 0.0;
  double resistance_temperature_1_K = kCopper_1_K;
  double dead_time_V = 0.0;
  double load_inertia_factor = 1.0;
  double load_mass_factor = 1.0;
  Oddities odd;

  bool is_two_mass() const { return gap_rad > 0.0 || stiffness_Nm_rad > 0.0; }
};

/// Where the machine is at one instant.
struct Instant {
  double time_s = 0.0;                                                   ///< Since the log began.
  double angle_rad = 0.0, speed_rad_s = 0.0, acceleration_rad_s2 = 0.0;  ///< Of the load.
  double motor_angle_rad = 0.0, motor_speed_rad_s = 0.0;                 ///< Over the ratio.
  double motor_acceleration_rad_s2 = 0.0;
  double current_A = 0.0;
  double current_rate_A_s = 0.0;
  double torque_current_A = 0.0;  ///< The current behind the lag.
  double winding_V = 0.0;         ///< What the drive means to apply.
  double bus_V = 0.0;
  double torque_Nm = 0.0;      ///< On the load.
  double bristle_Nm = 0.0;     ///< Presliding friction's state.
  double hysteresis_Nm = 0.0;  ///< State of `Oddities::hysteresis_Nm`.
  double winding_K = kReference_K, case_K = kReference_K;
  double commanded_A = 0.0, reference_rad = 0.0, brake_Nm = 0.0;
};

/// Torque of the magnets at the output, before friction and mesh.
double magnet_torque_Nm(const Plant& plant, const Laws& laws, double current_A, double winding_K);
/// Torque at the output per ampere of small current, at a temperature: factor and magnets.
double constant_Nm_A(const Plant& plant, const Laws& laws, double winding_K);
/// Dry friction's level at motion of a sign, a magnitude. torque_Nm: on the load.
double dry_friction_Nm(const Laws& laws, const Instant& at, double speed_rad_s, double sign);
/// Friction that grows with speed, signed like the speed.
double wet_friction_Nm(const Laws& laws, const Instant& at, double speed_rad_s);
/// What reaches the load of a torque before the mesh, moving towards `sign`.
double through_mesh_Nm(const Plant& plant, const Laws& laws, double torque_Nm, double sign);
/// Torques that act on the output itself.
double output_torques_Nm(const Laws& laws, const Instant& at, double mesh_Nm);
/// What the load takes at the motion: without a torque sensor the other side of the balance.
double load_torque_Nm(const Plant& plant, const Laws& laws, const Instant& at);
/// The current that the winding's voltage would drive under these laws.
double current_of_voltage_A(const Plant& plant, const Laws& laws, const Instant& at);
/// Torque on the load that these laws predict at the motion and current, or voltage, of `at`.
double predicted_torque_Nm(const Plant& plant, const Laws& laws, const Instant& at);

}  // namespace torquewright::oracles::sampled
