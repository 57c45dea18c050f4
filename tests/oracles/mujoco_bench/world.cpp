// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/mujoco_bench/world.hpp"

#include <functional>
#include <stdexcept>

namespace torquewright::oracles::mujoco_bench {
namespace {

using Json = nlohmann::ordered_json;
using PutOn = std::function<void(World&, const Json&)>;

double number(const Json& from, const char* key) { return from.at(key).get<double>(); }

std::vector<Harmonic> harmonics(const Json& from, const char* amplitude = "amplitude_Nm") {
  std::vector<Harmonic> read;
  for (const Json& one : from.at("harmonics"))
    read.push_back({number(one, "order"), number(one, amplitude), number(one, "phase_rad")});
  return read;
}

void ripple(World& w, const Json& p) {
  if (p.at("proportional").get<bool>())
    w.laws.load_ripple = harmonics(p, "amplitude_ratio");
  else
    w.laws.ripple = harmonics(p);
}

void asymmetric(World& w, const Json& p) {
  w.laws.coulomb_Nm[0] = number(p, "coulomb_positive_Nm");
  w.laws.coulomb_Nm[1] = number(p, "coulomb_negative_Nm");
  w.laws.viscous_Nm_s_rad[0] = number(p, "viscous_positive_Nm_s_rad");
  w.laws.viscous_Nm_s_rad[1] = number(p, "viscous_negative_Nm_s_rad");
}

void stribeck(World& w, const Json& p) {
  w.laws.coulomb_Nm[0] = w.laws.coulomb_Nm[1] = number(p, "coulomb_Nm");
  w.laws.breakaway_excess_Nm = number(p, "breakaway_Nm") - number(p, "coulomb_Nm");
  w.laws.stribeck_velocity_rad_s = number(p, "stribeck_velocity_rad_s");
}

const std::map<std::string, PutOn> kFriction = {
    {"coulomb_friction",
     [](World& w, const Json& p) {
       w.laws.coulomb_Nm[0] = w.laws.coulomb_Nm[1] = number(p, "coulomb_Nm");
     }},
    {"viscous_friction",
     [](World& w, const Json& p) {
       w.laws.viscous_Nm_s_rad[0] = w.laws.viscous_Nm_s_rad[1] = number(p, "viscous_Nm_s_rad");
     }},
    {"stribeck_friction", stribeck},
    {"asymmetric_friction", asymmetric},
    {"quadratic_drag",
     [](World& w, const Json& p) { w.laws.drag_Nm_s2_rad2 = number(p, "drag_Nm_s2_rad2"); }},
    {"load_dependent_friction",
     [](World& w, const Json& p) {
       w.laws.driving_coefficient = number(p, "driving_coefficient");
       w.laws.backdriving_coefficient = number(p, "backdriving_coefficient");
     }},
    {"presliding_friction",
     [](World& w, const Json& p) {
       w.laws.presliding_Nm = number(p, "coulomb_Nm");
       w.laws.presliding_stiffness_Nm_rad = number(p, "stiffness_Nm_rad");
     }},
    {"position_dependent_friction",
     [](World& w, const Json& p) { w.laws.tight_spots = harmonics(p); }},
    {"friction_temperature",
     [](World& w, const Json& p) { w.laws.grease_1_K = number(p, "coefficient_1_K"); }},
};

const std::map<std::string, PutOn> kMotorAndGear = {
    {"torque_constant_saturation",
     [](World& w, const Json& p) {
       w.laws.saturation_current_A = number(p, "saturation_current_A");
       w.laws.saturation_exponent = number(p, "exponent");
     }},
    {"torque_constant_temperature",
     [](World& w, const Json& p) { w.laws.magnet_1_K = number(p, "coefficient_1_K"); }},
    {"torque_constant_error",
     [](World& w, const Json& p) { w.laws.torque_constant_factor = number(p, "factor"); }},
    {"cogging_torque", [](World& w, const Json& p) { w.laws.cogging = harmonics(p); }},
    {"gear_ripple", ripple},
    {"backlash", [](World& w, const Json& p) { w.laws.gap_rad = number(p, "gap_rad"); }},
    {"torsional_compliance",
     [](World& w, const Json& p) {
       w.laws.stiffness_Nm_rad = number(p, "stiffness_Nm_rad");
       w.laws.damping_Nm_s_rad = number(p, "damping_Nm_s_rad");
     }},
    {"reflected_inertia",
     [](World& w, const Json& p) { w.laws.extra_inertia_kg_m2 = number(p, "inertia_kg_m2"); }},
    {"torque_lag", [](World& w, const Json& p) { w.laws.lag_s = number(p, "time_constant_s"); }},
    {"voltage_sag", [](World& w, const Json& p) { w.laws.sag_ohm = number(p, "resistance_ohm"); }},
    {"winding_resistance_temperature",
     [](World& w, const Json& p) { w.laws.copper_1_K = number(p, "coefficient_1_K"); }},
    {"inverter_dead_time",
     [](World& w, const Json& p) { w.laws.dead_time_V = number(p, "voltage_V"); }},
};

const std::map<std::string, PutOn> kRigAndLog = {
    {"gravity_imbalance",
     [](World& w, const Json& p) {
       w.load.imbalance_Nm = number(p, "amplitude_Nm");
       w.load.imbalance_phase_rad = number(p, "phase_rad");
     }},
    {"load_inertia_error",
     [](World& w, const Json& p) { w.load.inertia_kg_m2 = number(p, "value"); }},
    {"load_mass_error", [](World& w, const Json& p) { w.load.mass_kg = number(p, "value"); }},
    {"channel_delay",
     [](World& w, const Json& p) {
       w.sensors.delay_s[p.at("channel").get<std::string>()] = number(p, "delay_s");
     }},
    {"torque_offset",
     [](World& w, const Json& p) { w.sensors.torque_offset_Nm = number(p, "value"); }},
    {"current_offset",
     [](World& w, const Json& p) { w.sensors.current_offset_A = number(p, "value"); }},
    {"velocity_mismatch",
     [](World& w, const Json& p) {
       w.sensors.velocity_scale = number(p, "scale");
       w.sensors.velocity_delay_s = number(p, "delay_s");
     }},
};

void hum(World& w, const Json& p) {
  w.sensors.hum_channel = p.at("channel").get<std::string>();
  w.sensors.hum_amplitude = number(p, "amplitude");
  w.sensors.hum_hz = number(p, "hz");
}

const std::map<std::string, PutOn> kOutside = {
    {"parallel_spring",
     [](World& w, const Json& p) {
       w.load.spring_Nm_rad = number(p, "stiffness_Nm_rad");
       w.load.spring_rest_rad = number(p, "rest_rad");
     }},
    {"end_stop",
     [](World& w, const Json& p) {
       w.load.stop_rad = number(p, "stop_rad");
       w.load.stop_stiffness_Nm_rad = number(p, "stiffness_Nm_rad");
     }},
    {"encoder_eccentricity",
     [](World& w, const Json& p) {
       w.sensors.eccentricity_rad = number(p, "amplitude_rad");
       w.sensors.eccentricity_phase_rad = number(p, "phase_rad");
     }},
    {"encoder_interpolation",
     [](World& w, const Json& p) {
       w.sensors.interpolation_rad = number(p, "amplitude_rad");
       w.sensors.interpolation_order = number(p, "order");
     }},
    {"current_gain_by_sign",
     [](World& w, const Json& p) { w.sensors.gain_by_sign = number(p, "share"); }},
    {"current_dead_band",
     [](World& w, const Json& p) { w.sensors.dead_band_A = number(p, "width_A"); }},
    {"friction_growing_with_time",
     [](World& w, const Json& p) { w.laws.growth_Nm_s = number(p, "growth_Nm_s"); }},
    {"belt_slip",
     [](World& w, const Json& p) { w.sensors.creep_per_Nm = number(p, "creep_per_Nm"); }},
    {"harmonic_drive_play",
     [](World& w, const Json& p) {
       w.sensors.play_rad_Nm = number(p, "twist_rad_Nm");
       w.sensors.play_Nm = number(p, "play_Nm");
     }},
    {"torque_sensor_drift",
     [](World& w, const Json& p) { w.sensors.torque_drift_Nm_s = number(p, "drift_Nm_s"); }},
    {"payload_changes",
     [](World& w, const Json& p) {
       w.load.payload_share = p.at("shares").get<std::vector<double>>();
     }},
    {"iron_loss_with_current_squared",
     [](World& w, const Json& p) { w.laws.iron_loss_Nm_A2 = number(p, "loss_Nm_A2"); }},
    {"friction_falling_with_load",
     [](World& w, const Json& p) {
       w.laws.fading_Nm = number(p, "friction_Nm");
       w.laws.fading_load_Nm = number(p, "load_Nm");
     }},
    {"hum", hum},
};

}  // namespace

void put_on(World& world, const Effect& effect) {
  for (const auto* family : {&kFriction, &kMotorAndGear, &kRigAndLog, &kOutside})
    if (const auto found = family->find(effect.name); found != family->end())
      return found->second(world, effect.parameters);
  throw std::invalid_argument("no law is called " + effect.name);
}

}  // namespace torquewright::oracles::mujoco_bench
