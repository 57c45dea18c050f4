// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "tests/oracles/bench_log/harmonics.hpp"

namespace torquewright::oracles {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kCopper_1_K = 0.0039;  ///< Holds unless an effect says otherwise.
inline constexpr double kGravity_m_s2 = 9.80665;

/// Friction other than load-dependent, at the output. Values are for motion in the positive and
/// the negative direction.
struct Friction {
  double coulomb_positive_Nm = 0.0, coulomb_negative_Nm = 0.0;
  double viscous_positive_Nm_s_rad = 0.0, viscous_negative_Nm_s_rad = 0.0;
  double breakaway_excess_Nm = 0.0;  ///< Stribeck: breakaway over Coulomb.
  double stribeck_velocity_rad_s = 1.0;
  double drag_Nm_s2_rad2 = 0.0;
  Harmonics over_position;               ///< Of the Coulomb level, over the output angle.
  double coefficient_1_K = 0.0;          ///< All of it grows with the winding's temperature.
  double presliding_Nm_rad = kInfinity;  ///< Dahl's stiffness before slip; infinite: true sticking.
};

/// What the load is. Zeroes on a dynamometer, which imposes the motion.
struct Load {
  enum class Type { kDynamometer, kFree, kPendulum, kLinearAxis };
  Type type = Type::kDynamometer;
  double inertia_kg_m2 = 0.0;  ///< All of it about the axis (kg on a linear axis).
  double gravity_Nm = 0.0;     ///< m g l of a pendulum.
  double imbalance_Nm = 0.0, imbalance_phase_rad = 0.0;
};

/// What no effect of the library is. Neutral: zeroes.
struct Outside {
  double friction_growth_Nm_s = 0.0;  ///< Coulomb, against the time since the run's start.
  double tight_spot_Nm = 0.0, tight_spot_rad = 0.0, tight_spot_width_rad = 1.0;
  double commutation_ratio = 0.0, commutation_phase_rad = 0.0;  ///< 6th electrical harmonic.
  double cogging_fade_rad_s = kInfinity;                        ///< Cogging times exp(-|w| / this).
  double grease_Nm = 0.0, grease_s = 1.0;  ///< Friction that dies away after a reversal.
};

/// All constants of one drive and its load; the defaults of effects are neutral.
struct Machine {
  double ratio = 1.0, forward_efficiency = 1.0, backward_efficiency = 1.0;
  double torque_constant_Nm_A = 0.1, resistance_ohm = 0.3, rotor_inertia_kg_m2 = 1e-4;
  double bus_V = 48.0, peak_current_A = 30.0, reference_K = 298.15;
  int pole_pairs = 7;
  double winding_to_case_K_W = 1.0, case_to_ambient_K_W = 1.0, winding_J_K = 50.0;
  double case_J_K = 500.0, ambient_K = 298.15;

  Friction friction;
  double driving_coefficient = 0.0, backdriving_coefficient = 0.0;
  double saturation_current_A = kInfinity, saturation_exponent = 2.0;
  double torque_constant_1_K = 0.0, torque_constant_factor = 1.0;
  Harmonics cogging, ripple, load_ripple;  ///< Over the rotor's angle; the output's; a ratio.
  double gap_rad = 0.0;
  double stiffness_Nm_rad = kInfinity, damping_Nm_s_rad = 0.0;
  double extra_inertia_kg_m2 = 0.0;
  double lag_s = 0.0;
  double sag_ohm = 0.0, resistance_1_K = kCopper_1_K, dead_time_V = 0.0;
  Load load;
  Outside outside;

  /// Of everything on the motor's side, at the output.
  double motor_inertia_kg_m2() const {
    return ratio * ratio * rotor_inertia_kg_m2 + extra_inertia_kg_m2;
  }
  bool has_two_positions() const { return gap_rad > 0.0 || stiffness_Nm_rad < kInfinity; }
};

/// N Kt i with saturation, temperature and factor [N m at the output].
double motor_torque_Nm(const Machine& machine, double current_A, double winding_K);

/// Where and when friction is asked for.
struct Situation {
  double position_rad = 0.0;
  double speed_rad_s = 0.0;
  double winding_K = 298.15;
  double time_s = 0.0;
  double since_reversal_s = 1e9;
};

/// Magnitude of the friction against motion in the direction (+1 or -1), without presliding's and
/// the gear's; at speed 0 what must be overcome to start [N m at the output].
double friction_Nm(const Machine& machine, const Situation& situation, double direction);

/// Torque on the load from what reaches the gear (`net`: motor torque less inertia and drag, in the
/// direction of motion): net eta_f / (1 + k_d) driving, net / (eta_b (1 - k_b)) back-driven.
double through_gear_Nm(const Machine& machine, double net_Nm);
/// The inverse.
double before_gear_Nm(const Machine& machine, double load_Nm);

/// Voltage over the winding (dc): R(T) i + Ke w_motor + the inverter's error, which the commanded
/// voltage has to contain. Ke is Kt, with its temperature and factor.
double winding_voltage_V(const Machine& machine, double current_A, double motor_speed_rad_s,
                         double winding_K);
/// The current that a commanded voltage drives, without inductance.
double current_from_voltage_A(const Machine& machine, double voltage_V, double motor_speed_rad_s,
                              double winding_K);
/// Bus voltage where the winding takes `voltage_V` at `current_A`: V = V0 - R_s (u / V) i.
double bus_voltage_V(const Machine& machine, double voltage_V, double current_A);

}  // namespace torquewright::oracles
