// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/mujoco_bench/effects.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

namespace torquewright::oracles::mujoco_bench {
namespace {

using Json = nlohmann::ordered_json;

/// What a maker knows.
struct Scope {
  double scale;
  const Situation& it;
  Draws& draws;

  double torque() const { return it.peak_torque_Nm() * scale; }
  double speed() const { return it.top_speed_rad_s; }
  const Motor& motor() const { return it.stated.motor; }
  double phase() const { return draws.uniform(-std::numbers::pi, std::numbers::pi); }
};
using Maker = std::function<Json(const Scope&)>;

/// Of the peak torque; a mass that is swung without a sensor must not be held by friction.
double dry(const Scope& s) {
  return s.torque() * (s.it.stated.load.type == "dynamometer" ? 0.3 : 0.15);
}

double draw_rotor_order(Draws& draws) {
  return draws.one_of(std::vector<double>{4, 6, 7, 12, 14, 18, 24, 36, 42});
}

double draw_output_order(Draws& draws) {
  return draws.one_of(std::vector<double>{1, 2, 3, 4, 7, 11, 19, 30});
}

Json harmonic(double order, const char* key, double amplitude, double phase) {
  return {{"order", order}, {key, amplitude}, {"phase_rad", phase}};
}

Json cogging(const Scope& s) {
  const double order = draw_rotor_order(s.draws);
  Json list = {harmonic(order, "amplitude_Nm", 0.12 * s.torque(), s.phase())};
  if (s.draws.chance(0.4))
    list.push_back(harmonic(2 * order, "amplitude_Nm", 0.04 * s.torque(), s.phase()));
  return {{"harmonics", list}};
}

Json ripple(const Scope& s) {
  const double order = draw_output_order(s.draws);
  const bool proportional = s.draws.chance(0.4) && s.it.stated.load.type == "dynamometer";
  const char* key = proportional ? "amplitude_ratio" : "amplitude_Nm";
  const double amplitude = proportional ? 0.15 * s.scale : 0.12 * s.torque();
  return {{"harmonics", {harmonic(order, key, amplitude, s.phase())}},
          {"proportional", proportional}};
}

Json tight_spots(const Scope& s) {
  const double order = std::min(7.0, draw_output_order(s.draws));
  return {{"harmonics", {harmonic(order, "amplitude_Nm", 0.4 * dry(s), s.phase())}}};
}

Json stribeck(const Scope& s) {
  return {{"coulomb_Nm", 0.6 * dry(s)},
          {"breakaway_Nm", dry(s)},
          {"stribeck_velocity_rad_s", s.speed() * s.draws.log_uniform(0.02, 0.12)}};
}

Json asymmetric(const Scope& s) {
  const double less = s.draws.uniform(0.2, 0.7);
  const bool forwards = s.draws.chance(0.5);
  return {{"coulomb_positive_Nm", dry(s) * (forwards ? 1 : less)},
          {"coulomb_negative_Nm", dry(s) * (forwards ? less : 1)},
          {"viscous_positive_Nm_s_rad", 0.0},
          {"viscous_negative_Nm_s_rad", 0.0}};
}

Json presliding(const Scope& s) {
  return {{"coulomb_Nm", dry(s)}, {"stiffness_Nm_rad", dry(s) / s.draws.log_uniform(2e-3, 3e-2)}};
}

/// The rotor on the gear's spring stays below 400 Hz, which the step resolves.
Json compliance(const Scope& s) {
  const double armature = s.motor().armature_kg_m2(), fastest = 2 * std::numbers::pi * 400;
  const double stiffness =
      std::min(s.it.peak_torque_Nm() / (0.05 * s.scale), armature * fastest * fastest);
  const double damping = s.draws.uniform(0.05, 0.2) * std::sqrt(stiffness * armature);
  return {{"stiffness_Nm_rad", stiffness}, {"damping_Nm_s_rad", damping}};
}

Json delay(const Scope& s) {
  std::vector<std::string> channels;
  for (const char* one : {"motor_current_A", "output_torque_Nm"})
    if (s.it.format.has(one)) channels.emplace_back(one);
  if (channels.empty() || !s.it.format.has("output_torque_Nm")) channels = {"motor_current_A"};
  return {{"channel", s.draws.one_of(channels)}, {"delay_s", 0.03 * s.scale}};
}

Json of_load(const Scope& s, double stated) {
  return {{"value", stated * (1 + s.draws.sign() * 0.5 * s.scale)}};
}

const std::map<std::string, Maker> kMakers = {
    {"viscous_friction",
     [](const Scope& s) {
       return Json{{"viscous_Nm_s_rad", dry(s) / s.speed()}};
     }},
    {"coulomb_friction",
     [](const Scope& s) {
       return Json{{"coulomb_Nm", dry(s)}};
     }},
    {"stribeck_friction", stribeck},
    {"asymmetric_friction", asymmetric},
    {"quadratic_drag",
     [](const Scope& s) {
       return Json{{"drag_Nm_s2_rad2", dry(s) / s.speed() / s.speed()}};
     }},
    {"load_dependent_friction",
     [](const Scope& s) {
       return Json{{"driving_coefficient", 0.45 * s.scale},
                   {"backdriving_coefficient", 0.45 * s.scale * s.draws.uniform(0.7, 1.2)}};
     }},
    {"presliding_friction", presliding},
    {"torque_constant_saturation",
     [](const Scope& s) {
       return Json{{"saturation_current_A", 0.45 * s.motor().peak_current_A / s.scale},
                   {"exponent", s.draws.uniform(1.5, 3.5)}};
     }},
    {"torque_constant_temperature",
     [](const Scope& s) {
       return Json{{"coefficient_1_K", -0.003 * s.scale}};
     }},
    {"friction_temperature",
     [](const Scope& s) {
       return Json{{"coefficient_1_K", -0.012 * s.scale}};
     }},
    {"cogging_torque", cogging},
    {"gear_ripple", ripple},
    {"position_dependent_friction", tight_spots},
    {"backlash",
     [](const Scope& s) {
       return Json{{"gap_rad", 0.04 * s.scale}};
     }},
    {"torsional_compliance", compliance},
    {"reflected_inertia",
     [](const Scope& s) {
       return Json{{"inertia_kg_m2", 1.5 * s.scale * s.motor().armature_kg_m2()}};
     }},
    {"torque_lag",
     [](const Scope& s) {
       return Json{{"time_constant_s", 0.03 * s.scale}};
     }},
    {"voltage_sag",
     [](const Scope& s) {
       return Json{
           {"resistance_ohm", 0.2 * s.scale * s.motor().bus_voltage_V / s.motor().peak_current_A}};
     }},
    {"winding_resistance_temperature",
     [](const Scope& s) {
       return Json{{"coefficient_1_K", 0.0039 + s.draws.sign() * 0.0039 * s.scale}};
     }},
    {"inverter_dead_time",
     [](const Scope& s) {
       return Json{
           {"voltage_V", 0.25 * s.scale * s.motor().resistance_ohm * s.motor().peak_current_A}};
     }},
    {"torque_constant_error",
     [](const Scope& s) {
       return Json{{"factor", 1 + s.draws.sign() * 0.35 * s.scale}};
     }},
    {"gravity_imbalance",
     [](const Scope& s) {
       return Json{{"amplitude_Nm", 0.25 * s.torque()}, {"phase_rad", s.phase()}};
     }},
    {"load_inertia_error",
     [](const Scope& s) { return of_load(s, s.it.stated.load.inertia_kg_m2); }},
    {"load_mass_error", [](const Scope& s) { return of_load(s, s.it.stated.load.mass_kg); }},
    {"channel_delay", delay},
    {"torque_offset",
     [](const Scope& s) {
       return Json{{"value", s.draws.sign() * 0.25 * s.torque()}};
     }},
    {"current_offset",
     [](const Scope& s) {
       return Json{{"value", s.draws.sign() * 0.25 * s.scale * s.motor().peak_current_A}};
     }},
    {"velocity_mismatch",
     [](const Scope& s) {
       return Json{{"scale", 1 + s.draws.sign() * 0.2 * s.scale},
                   {"delay_s", s.draws.chance(0.5) ? 0.02 * s.scale : 0.0}};
     }},
};

const std::vector<std::string> kSensor = {"dynamometer"};
const std::vector<std::string> kNoGravity = {"dynamometer", "free"};
const std::vector<std::string> kNoSensor = {"free", "pendulum"};

const std::map<std::string, Demand> kDemands = {
    {"load_dependent_friction", {.loads = kSensor}},
    {"presliding_friction", {.loads = kSensor}},
    {"torque_constant_saturation", {.loads = kSensor, .drive = "current"}},
    {"torque_constant_temperature", {.loads = kSensor, .temperature = true, .drive = "current"}},
    {"friction_temperature", {.loads = kNoGravity, .temperature = true}},
    {"position_dependent_friction", {.loads = kNoGravity}},
    {"backlash", {.loads = kSensor, .two_encoders = true, .drive = "current", .gentle = true}},
    {"torsional_compliance",
     {.loads = {"dynamometer", "pendulum"},
      .two_encoders = true,
      .drive = "current",
      .gentle = true}},
    {"torque_lag", {.loads = kSensor, .drive = "current", .fast_torque = true}},
    {"voltage_sag", {.drive = "duty"}},
    {"winding_resistance_temperature", {.temperature = true, .drive = "duty"}},
    {"inverter_dead_time", {.drive = "duty"}},
    {"torque_constant_error", {.loads = {"dynamometer", "free", "pendulum"}, .drive = "current"}},
    {"gravity_imbalance", {.loads = kNoGravity, .output_order = 1}},
    {"load_inertia_error", {.loads = kNoSensor, .drive = "current"}},
    {"load_mass_error", {.loads = {"pendulum", "linear_axis"}, .drive = "current"}},
    {"channel_delay", {.loads = kNoGravity, .drive = "current", .fast_torque = true}},
    {"torque_offset", {.loads = kSensor}},
    {"current_offset", {.loads = {"dynamometer", "free", "pendulum"}, .drive = "current"}},
    {"velocity_mismatch", {.velocity = true}},
};

const std::set<std::string> kDry = {"coulomb_friction", "stribeck_friction", "asymmetric_friction",
                                    "presliding_friction"};
const std::set<std::string> kOffsets = {"torque_offset", "current_offset", "asymmetric_friction"};
const std::set<std::string> kElastic = {"backlash", "torsional_compliance"};

std::vector<std::string> rotor_inertia_names(const Situation& it) {
  if (it.stated.load.type == "dynamometer") return {"reflected_inertia"};
  if (it.stated.load.type == "linear_axis") return {"reflected_inertia", "load_mass_error"};
  return {"reflected_inertia", "load_inertia_error"};
}

bool counts_rotor_in_output_turns(const Situation& it) {
  const double ratio = it.stated.motor.ratio;
  return std::abs(ratio - std::round(ratio)) < 1e-9 && !it.format.has("motor_position_rad");
}

std::vector<std::string> torque_constant_names(const Situation& it) {
  if (it.stated.load.type == "free")
    return {"torque_constant_error", "load_inertia_error", "reflected_inertia"};
  if (it.stated.load.type == "pendulum") return {"torque_constant_error", "load_mass_error"};
  return {"torque_constant_error"};
}

}  // namespace

const std::vector<std::string>& effect_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& [name, maker] : kMakers) all.push_back(name);
    return all;
  }();
  return names;
}

Demand demand_of(const std::string& effect, Draws draws) {
  if (effect == "cogging_torque")
    return {.loads = kNoGravity, .rotor_order = draw_rotor_order(draws)};
  if (effect == "gear_ripple")
    return {.loads = kNoGravity, .output_order = draw_output_order(draws)};
  const auto found = kDemands.find(effect);
  return found == kDemands.end() ? Demand{} : found->second;
}

Effect make_effect(const std::string& name, double scale, const Situation& it, Draws draws) {
  return {name, kMakers.at(name)(Scope{scale, it, draws})};
}

std::vector<Effect> companions(const std::string& effect, const Situation& it, Draws& draws) {
  const double level = draws.uniform(0.3, 0.6);
  if (effect == "position_dependent_friction")
    return {make_effect("coulomb_friction", 0.5, it, draws)};
  if (effect == "friction_temperature")
    return {make_effect("coulomb_friction", level, it, draws),
            make_effect("viscous_friction", level, it, draws)};
  return {};
}

bool agree(const std::string& a, const std::string& b) {
  const auto both = [&](const std::set<std::string>& set) {
    return set.contains(a) && set.contains(b);
  };
  const auto is = [&](const char* one, const char* other) {
    return (a == one && b == other) || (a == other && b == one);
  };
  return a != b && !both(kDry) && !both(kOffsets) && !both(kElastic) &&
         !is("asymmetric_friction", "viscous_friction") && !is("channel_delay", "torque_lag");
}

std::vector<std::string> identical_names(const Effect& effect, const Situation& it) {
  const std::string& name = effect.name;
  if (kOffsets.contains(name)) {
    std::vector<std::string> all = {name};
    for (const std::string& one : kOffsets)
      if (one != name) all.push_back(one);
    return all;
  }
  if (name == "torque_constant_error") return torque_constant_names(it);
  const auto inertias = rotor_inertia_names(it);
  if (name == "load_mass_error" && it.stated.load.type == "pendulum")
    return {"load_mass_error", "torque_constant_error", "gravity_imbalance"};
  if (std::find(inertias.begin(), inertias.end(), name) != inertias.end()) return inertias;
  if (name == "cogging_torque" && counts_rotor_in_output_turns(it))
    return {"cogging_torque", "gear_ripple"};
  const bool first_order = name == "gear_ripple" && !effect.parameters.at("proportional") &&
                           effect.parameters.at("harmonics").at(0).at("order") == 1;
  if (name == "gravity_imbalance" || first_order)
    return {name, first_order ? "gravity_imbalance" : "gear_ripple"};
  return {name};
}

}  // namespace torquewright::oracles::mujoco_bench
