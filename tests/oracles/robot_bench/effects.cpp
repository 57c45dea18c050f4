// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/robot_bench/effects.hpp"

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>

namespace torquewright::oracles::robot_bench {
namespace {

/// What a maker knows.
struct Scope {
  double scale;
  const Flavour& flavour;
  const Usage& usage;
  const Laws& stated;
};
using Maker = std::function<Json(const Scope&)>;
using Putter = std::function<void(Laws&, const Json&)>;

/// The rotor on its spring stays below this, which the step resolves.
constexpr double kFastest_rad_s = 2 * std::numbers::pi * 300;

double dry(const Scope& s) { return 0.8 * s.usage.torque_Nm * s.scale; }

Json asymmetric(const Scope& s) {
  const double less = dry(s) * (0.1 + 0.5 * s.flavour.a);
  const bool forwards = s.flavour.sign > 0;
  return {{"coulomb_positive_Nm", forwards ? dry(s) : less},
          {"coulomb_negative_Nm", forwards ? less : dry(s)},
          {"viscous_positive_Nm_s_rad", 0.0},
          {"viscous_negative_Nm_s_rad", 0.0}};
}

Json stribeck(const Scope& s) {
  return {{"coulomb_Nm", dry(s) * (0.3 + 0.4 * s.flavour.a)},
          {"breakaway_Nm", dry(s)},
          {"stribeck_velocity_rad_s", s.usage.speed_rad_s * 0.03 * std::pow(10, s.flavour.b)}};
}

Json load_friction(const Scope& s) {
  const double driving = 0.5 * s.scale;
  return {{"driving_coefficient", driving},
          {"backdriving_coefficient", driving * (0.4 + 0.5 * s.flavour.a)}};
}

Json ripple(const Scope& s) {
  return {{"harmonics",
           {{{"order", s.flavour.order},
             {"amplitude_Nm", 0.8 * s.usage.torque_Nm * s.scale},
             {"phase_rad", s.flavour.phase_rad}}}},
          {"proportional", false}};
}

Json compliance(const Scope& s) {
  const double stiffness = std::min(s.usage.peak_Nm / (0.3 * s.scale),
                                    s.stated.armature_kg_m2 * kFastest_rad_s * kFastest_rad_s);
  return {{"stiffness_Nm_rad", stiffness},
          {"damping_Nm_s_rad",
           (0.1 + 0.3 * s.flavour.a) * std::sqrt(stiffness * s.stated.armature_kg_m2)}};
}

Json spring(const Scope& s) {
  return {
      {"stiffness_Nm_rad", s.usage.torque_Nm / s.usage.swing_rad() * s.scale},
      {"neutral_angle_rad", s.usage.low_rad + 2 * s.usage.swing_rad() * (0.2 + 0.6 * s.flavour.a)}};
}

/// Met in the outer part of the motion.
Json stop(const Scope& s) {
  const bool upper = s.flavour.sign > 0;
  const double inside = s.usage.swing_rad() * (0.1 + 0.4 * s.flavour.a);
  return {{"stiffness_Nm_rad", 20 * s.usage.torque_Nm / s.usage.swing_rad() * s.scale},
          {"angle_rad", upper ? s.usage.high_rad - inside : s.usage.low_rad + inside}};
}

Json factor(const Scope& s) { return {{"factor", 1 + s.flavour.sign * 0.45 * s.scale}}; }

const std::map<std::string, Maker> kMakers = {
    {"coulomb_friction",
     [](const Scope& s) {
       return Json{{"coulomb_Nm", dry(s)}};
     }},
    {"viscous_friction",
     [](const Scope& s) {
       return Json{{"viscous_Nm_s_rad", dry(s) / s.usage.speed_rad_s}};
     }},
    {"asymmetric_friction", asymmetric},
    {"stribeck_friction", stribeck},
    {"load_dependent_friction", load_friction},
    {"gear_ripple", ripple},
    {"backlash",
     [](const Scope& s) {
       return Json{{"gap_rad", 0.1 * s.scale}};
     }},
    {"torsional_compliance", compliance},
    {"torque_constant_error", factor},
    {"torque_lag",
     [](const Scope& s) {
       return Json{{"time_constant_s", 0.06 * s.scale}};
     }},
    {"command_delay",
     [](const Scope& s) {
       return Json{{"delay_s", 0.08 * s.scale}};
     }},
    {"parallel_spring", spring},
    {"upper_end_stop", stop},
    {"lower_end_stop",
     [](const Scope& s) {
       Flavour below = s.flavour;
       below.sign = -1;
       return stop({s.scale, below, s.usage, s.stated});
     }},
    {"reflected_inertia",
     [](const Scope& s) {
       return Json{{"inertia_kg_m2", 2 * s.stated.armature_kg_m2 * s.scale}};
     }},
};

double number(const Json& json, const char* key) { return json.at(key).get<double>(); }

void put_asymmetric(Laws& laws, const Json& p) {
  laws.coulomb_Nm[0] += number(p, "coulomb_positive_Nm");
  laws.coulomb_Nm[1] += number(p, "coulomb_negative_Nm");
  laws.viscous_Nm_s_rad[0] += number(p, "viscous_positive_Nm_s_rad");
  laws.viscous_Nm_s_rad[1] += number(p, "viscous_negative_Nm_s_rad");
}

void put_stribeck(Laws& laws, const Json& p) {
  for (double& level : laws.coulomb_Nm) level += number(p, "coulomb_Nm");
  laws.breakaway_excess_Nm = number(p, "breakaway_Nm") - number(p, "coulomb_Nm");
  laws.stribeck_velocity_rad_s = number(p, "stribeck_velocity_rad_s");
}

void put_ripple(Laws& laws, const Json& p) {
  for (const Json& one : p.at("harmonics"))
    laws.ripple.push_back(
        {number(one, "order"), number(one, "amplitude_Nm"), number(one, "phase_rad")});
}

/// Flanks are a spring against the rotor.
void put_backlash(Laws& laws, const Json& p) {
  laws.gap_rad = number(p, "gap_rad");
  laws.stiffness_Nm_rad = laws.armature_kg_m2 * kFastest_rad_s * kFastest_rad_s;
  laws.twist_damping_Nm_s_rad = 0.4 * laws.armature_kg_m2 * kFastest_rad_s;
}

const std::map<std::string, Putter> kPutters = {
    {"coulomb_friction",
     [](Laws& laws, const Json& p) {
       for (double& level : laws.coulomb_Nm) level += number(p, "coulomb_Nm");
     }},
    {"viscous_friction",
     [](Laws& laws, const Json& p) {
       for (double& slope : laws.viscous_Nm_s_rad) slope += number(p, "viscous_Nm_s_rad");
     }},
    {"asymmetric_friction", put_asymmetric},
    {"stribeck_friction", put_stribeck},
    {"load_dependent_friction",
     [](Laws& laws, const Json& p) {
       laws.driving_coefficient += number(p, "driving_coefficient");
       laws.backdriving_coefficient += number(p, "backdriving_coefficient");
     }},
    {"gear_ripple", put_ripple},
    {"backlash", put_backlash},
    {"torsional_compliance",
     [](Laws& laws, const Json& p) {
       laws.stiffness_Nm_rad = number(p, "stiffness_Nm_rad");
       laws.twist_damping_Nm_s_rad = number(p, "damping_Nm_s_rad");
     }},
    {"torque_constant_error",
     [](Laws& laws, const Json& p) { laws.torque_factor *= number(p, "factor"); }},
    {"torque_lag", [](Laws& laws, const Json& p) { laws.lag_s += number(p, "time_constant_s"); }},
    {"command_delay",
     [](Laws& laws, const Json& p) { laws.command_delay_s += number(p, "delay_s"); }},
    {"parallel_spring",
     [](Laws& laws, const Json& p) {
       laws.spring_Nm_rad = number(p, "stiffness_Nm_rad");
       laws.spring_neutral_rad = number(p, "neutral_angle_rad");
     }},
    {"upper_end_stop",
     [](Laws& laws, const Json& p) {
       laws.upper = {number(p, "stiffness_Nm_rad"), number(p, "angle_rad")};
     }},
    {"lower_end_stop",
     [](Laws& laws, const Json& p) {
       laws.lower = {number(p, "stiffness_Nm_rad"), number(p, "angle_rad")};
     }},
    {"reflected_inertia",
     [](Laws& laws, const Json& p) { laws.armature_kg_m2 += number(p, "inertia_kg_m2"); }},
};

}  // namespace

Flavour draw_flavour(mujoco_bench::Draws& draws) {
  Flavour flavour;
  flavour.a = draws.uniform(0, 1);
  flavour.b = draws.uniform(0, 1);
  flavour.sign = draws.sign();
  flavour.order = draws.one_of(std::vector<double>{3, 4, 7, 11, 19, 30});
  flavour.phase_rad = draws.uniform(-std::numbers::pi, std::numbers::pi);
  return flavour;
}

std::vector<std::string> effect_names() {
  std::vector<std::string> names;
  for (const auto& [name, maker] : kMakers) names.push_back(name);
  return names;
}

Json parameters_of(const std::string& name, double scale, const Flavour& flavour,
                   const Usage& usage, const Laws& stated) {
  Flavour above = flavour;
  if (name == "upper_end_stop") above.sign = 1;
  return kMakers.at(name)({scale, above, usage, stated});
}

void put_on(Laws& laws, const std::string& name, const Json& parameters) {
  const auto found = kPutters.find(name);
  if (found == kPutters.end()) throw std::invalid_argument("no such effect: " + name);
  found->second(laws, parameters);
}

std::vector<std::string> accepted_names(const std::string& name) {
  if (name == "torque_constant_error") return {name, "/controller/stiffness_Nm_rad"};
  if (name == "command_delay") return {name, "/controller/delay_s"};
  if (name == "viscous_friction") return {name, "/controller/damping_Nm_s_rad"};
  return {name};
}

}  // namespace torquewright::oracles::robot_bench
