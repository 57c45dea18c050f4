// SPDX-License-Identifier: Apache-2.0
// What is on the bench, as it is in truth. Neutral values change nothing.
#pragma once

#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace torquewright::oracles::mujoco_bench {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// A sin(order angle + phase); the amplitude's unit is that of what it changes.
struct Harmonic {
  double order, amplitude, phase_rad;
};

/// The stated numbers of motor and gear. Convention `dc`: torque Kt i, V = R i + Kt w.
struct Motor {
  double torque_constant_Nm_A = 0.1, resistance_ohm = 0.1, rotor_inertia_kg_m2 = 1e-4;
  double ratio = 9, bus_voltage_V = 48, peak_current_A = 20;
  double reference_temperature_K = 298.15;
  double forward_efficiency = 1, backward_efficiency = 1;
  int pole_pairs = 7;

  double gain_Nm_A() const { return ratio * torque_constant_Nm_A; }
  double armature_kg_m2() const { return ratio * ratio * rotor_inertia_kg_m2; }
};

/// Laws of the actuator, all torques at the output.
struct Laws {
  // Dry and viscous friction, by direction: forwards, backwards.
  double coulomb_Nm[2] = {0, 0}, viscous_Nm_s_rad[2] = {0, 0};
  double breakaway_excess_Nm = 0, stribeck_velocity_rad_s = 1;
  double drag_Nm_s2_rad2 = 0;
  double driving_coefficient = 0, backdriving_coefficient = 0;
  double presliding_Nm = 0, presliding_stiffness_Nm_rad = 0;
  std::vector<Harmonic> tight_spots, cogging, ripple, load_ripple;
  double saturation_current_A = kNever, saturation_exponent = 2;
  double magnet_1_K = 0, grease_1_K = 0, copper_1_K = 0.0039;
  double torque_constant_factor = 1;
  double gap_rad = 0, stiffness_Nm_rad = kNever, damping_Nm_s_rad = 0;
  double extra_inertia_kg_m2 = 0;
  double lag_s = 0;
  double sag_ohm = 0, dead_time_V = 0;
  // What no effect describes.
  double iron_loss_Nm_A2 = 0, growth_Nm_s = 0;
  double fading_Nm = 0, fading_load_Nm = 1;

  bool is_elastic() const { return gap_rad > 0 || stiffness_Nm_rad < kNever; }
};

/// What the actuator moves. A pendulum's inertia is about its centre of mass.
struct Load {
  std::string type = "dynamometer";
  double inertia_kg_m2 = 0, mass_kg = 0, length_m = 0;
  double imbalance_Nm = 0, imbalance_phase_rad = 0;
  double spring_Nm_rad = 0, spring_rest_rad = 0;
  double stop_rad = kNever, stop_stiffness_Nm_rad = 0;
  /// Added at the pendulum's centre of mass, or as inertia of a free load, by run.
  std::vector<double> payload_share = {};
};

/// From what is true to what is logged, but for the noise.
struct Sensors {
  double torque_offset_Nm = 0, current_offset_A = 0;
  double torque_drift_Nm_s = 0;
  std::map<std::string, double> delay_s;
  double velocity_scale = 1, velocity_delay_s = 0;
  double eccentricity_rad = 0, eccentricity_phase_rad = 0;
  double interpolation_rad = 0, interpolation_order = 1;
  double gain_by_sign = 0, dead_band_A = 0;
  double creep_per_Nm = 0;
  double play_rad_Nm = 0, play_Nm = 0;
  std::string hum_channel;
  double hum_amplitude = 0, hum_hz = 0;
};

struct World {
  Motor motor;
  Laws laws;
  Load load;
  Sensors sensors;
};

/// As in the documents: a name and its parameters.
struct Effect {
  std::string name;
  nlohmann::ordered_json parameters;
};

/// The world with one more effect, or one more kind of `outside`.
/// @throws std::invalid_argument for a name that is neither.
void put_on(World& world, const Effect& effect);

}  // namespace torquewright::oracles::mujoco_bench
