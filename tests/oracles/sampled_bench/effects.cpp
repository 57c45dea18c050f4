// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/sampled_bench/effects.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

namespace torquewright::oracles::sampled {
namespace {

using nlohmann::json;

/// What a strength and a shape are drawn for.
struct Order {
  double strength;
  Draw& draw;
  const Plant& plant;
  const Laws& stated;
  double torque_Nm, speed_rad_s;  ///< That the excitation uses.
};

json harmonic(double order, const char* key, double amplitude, Draw& draw) {
  return {{"order", order}, {key, amplitude}, {"phase_rad", draw.uniform(-3.1, 3.1)}};
}

double base_coulomb(const Order& o) {
  const double own = o.draw.uniform(0.05, 0.15) * o.torque_Nm;
  return o.stated.coulomb_positive_Nm > 0.0 ? o.stated.coulomb_positive_Nm : own;
}

json stribeck(const Order& o) {
  const double coulomb = base_coulomb(o);
  return {{"coulomb_Nm", coulomb},
          {"breakaway_Nm", coulomb + 0.45 * o.strength * o.torque_Nm},
          {"stribeck_velocity_rad_s", o.draw.uniform(0.08, 0.25) * o.speed_rad_s}};
}

json asymmetric(const Order& o) {
  const double mean = base_coulomb(o);
  const double viscous = o.stated.viscous_positive_Nm_s_rad;
  const double levels = o.draw.sign() * 0.25 * o.strength * o.torque_Nm;
  // Half of them differ in the dry level alone: then they are an offset.
  const double slopes =
      o.draw.chance(0.5) ? 0.0 : o.draw.sign() * 0.25 * o.strength * o.torque_Nm / o.speed_rad_s;
  const double dry = std::max(mean, std::abs(levels));
  const double wet = std::max(viscous, std::abs(slopes));
  return {{"coulomb_positive_Nm", dry + levels},
          {"coulomb_negative_Nm", dry - levels},
          {"viscous_positive_Nm_s_rad", wet + slopes},
          {"viscous_negative_Nm_s_rad", wet - slopes}};
}

json presliding(const Order& o) {
  const double coulomb = std::max(base_coulomb(o), 0.15 * o.torque_Nm);
  const double level = o.stated.coulomb_positive_Nm > 0.0 ? o.stated.coulomb_positive_Nm : coulomb;
  const double give_rad = 0.3 * o.strength * o.plant.used_angle_rad;
  return {{"coulomb_Nm", level}, {"stiffness_Nm_rad", level / give_rad}};
}

json cogging(const Order& o) {
  const double slots = o.draw.one_of(std::vector<double>{6, 12, 18, 24, 36});
  json list = {harmonic(slots, "amplitude_Nm", 0.3 * o.strength * o.torque_Nm, o.draw)};
  if (o.draw.chance(0.4)) {
    list.push_back(harmonic(2 * slots, "amplitude_Nm", 0.1 * o.strength * o.torque_Nm, o.draw));
  }
  return {{"harmonics", list}};
}

json ripple(const Order& o) {
  const bool proportional = o.draw.chance(0.3);
  const double amplitude = 0.3 * o.strength * (proportional ? 1.0 : o.torque_Nm);
  const char* key = proportional ? "amplitude_ratio" : "amplitude_Nm";
  const double order = o.draw.between(2, 16);
  return {{"harmonics", {harmonic(order, key, amplitude, o.draw)}}, {"proportional", proportional}};
}

json tight_spots(const Order& o) {
  const double amplitude = 0.9 * o.strength * o.stated.coulomb_positive_Nm;
  return {{"harmonics", {harmonic(o.draw.between(1, 4), "amplitude_Nm", amplitude, o.draw)}}};
}

json compliance(const Order& o) {
  const Plant& plant = o.plant;
  const double stiffness = o.torque_Nm / (0.08 * o.strength * plant.used_angle_rad);
  const double motor = plant.armature_kg_m2();
  const double load = plant.load.about_axis_kg_m2();
  const double reduced = load > 0.0 ? motor * load / (motor + load) : motor;
  const double damping = o.draw.uniform(0.04, 0.2) * 2.0 * std::sqrt(stiffness * reduced);
  return {{"stiffness_Nm_rad", stiffness}, {"damping_Nm_s_rad", damping}};
}

json late_channel(const Order& o) {
  const bool torque = o.plant.load.is_dynamometer() && o.draw.chance(0.6);
  const double delay_s = kStep_s * std::round(0.08 * o.strength / kStep_s);
  return {{"channel", torque ? "output_torque_Nm" : "motor_current_A"}, {"delay_s", delay_s}};
}

json velocity_mismatch(const Order& o) {
  const bool late = o.draw.chance(0.3);
  const double scale = late ? 1.0 : 1.0 + o.draw.sign() * 0.09 * o.strength;
  const double delay_s = late ? kStep_s * std::round(0.06 * o.strength / kStep_s) : 0.0;
  return {{"scale", scale}, {"delay_s", delay_s}};
}

using Maker = std::function<json(const Order&)>;

/// Effects of one number, or of numbers without a choice.
const std::map<std::string, Maker>& makers() {
  static const std::map<std::string, Maker> kMakers{
      {"viscous_friction",
       [](const Order& o) {
         return json{{"viscous_Nm_s_rad", 0.6 * o.strength * o.torque_Nm / o.speed_rad_s}};
       }},
      {"coulomb_friction",
       [](const Order& o) {
         return json{{"coulomb_Nm", 0.6 * o.strength * o.torque_Nm}};
       }},
      {"stribeck_friction", stribeck},
      {"asymmetric_friction", asymmetric},
      {"quadratic_drag",
       [](const Order& o) {
         const double square = o.speed_rad_s * o.speed_rad_s;
         return json{{"drag_Nm_s2_rad2", 0.6 * o.strength * o.torque_Nm / square}};
       }},
      {"load_dependent_friction",
       [](const Order& o) {
         return json{{"driving_coefficient", 0.5 * o.strength},
                     {"backdriving_coefficient", o.strength * o.draw.uniform(0.25, 0.5)}};
       }},
      {"presliding_friction", presliding},
      {"torque_constant_saturation",
       [](const Order& o) {
         const double current_A = o.torque_Nm / o.plant.Nm_per_A();
         return json{{"saturation_current_A", 0.7 * current_A / o.strength},
                     {"exponent", o.draw.uniform(1.6, 3.5)}};
       }},
      {"torque_constant_temperature",
       [](const Order& o) {
         return json{{"coefficient_1_K", -0.005 * o.strength}};
       }},
      {"friction_temperature",
       [](const Order& o) {
         return json{{"coefficient_1_K", -0.012 * o.strength}};
       }},
      {"cogging_torque", cogging},
      {"gear_ripple", ripple},
      {"position_dependent_friction", tight_spots},
      {"backlash",
       [](const Order& o) {
         return json{{"gap_rad", 0.15 * o.strength * o.plant.used_angle_rad}};
       }},
      {"torsional_compliance", compliance},
      {"reflected_inertia",
       [](const Order& o) {
         return json{{"inertia_kg_m2", 1.5 * o.strength * o.plant.moved_kg_m2()}};
       }},
      {"torque_lag",
       [](const Order& o) {
         return json{{"time_constant_s", 0.08 * o.strength}};
       }},
      {"voltage_sag",
       [](const Order& o) {
         const double current_A = o.torque_Nm / o.plant.Nm_per_A();
         return json{{"resistance_ohm", 0.25 * o.strength * o.plant.bus_V / current_A}};
       }},
      {"winding_resistance_temperature",
       [](const Order& o) {
         return json{{"coefficient_1_K", kCopper_1_K + o.draw.sign() * 0.0039 * o.strength}};
       }},
      {"inverter_dead_time",
       [](const Order& o) {
         return json{{"voltage_V", 0.05 * o.strength * o.plant.bus_V}};
       }},
      {"torque_constant_error",
       [](const Order& o) {
         return json{{"factor", 1.0 + o.draw.sign() * 0.3 * o.strength}};
       }},
      {"gravity_imbalance",
       [](const Order& o) {
         return json{{"amplitude_Nm", 0.4 * o.strength * o.torque_Nm},
                     {"phase_rad", o.draw.uniform(0.5, 2.6) * o.draw.sign()}};
       }},
      {"load_inertia_error",
       [](const Order& o) {
         return json{{"value", o.plant.load.inertia_kg_m2 * (1.0 + 1.2 * o.strength)}};
       }},
      {"load_mass_error",
       [](const Order& o) {
         return json{{"value", o.plant.load.mass_kg * (1.0 + o.draw.sign() * 0.45 * o.strength)}};
       }},
      {"channel_delay", late_channel},
      {"torque_offset",
       [](const Order& o) {
         return json{{"value", o.draw.sign() * 0.3 * o.strength * o.torque_Nm}};
       }},
      {"current_offset",
       [](const Order& o) {
         const double current_A = o.torque_Nm / o.plant.Nm_per_A();
         return json{{"value", o.draw.sign() * 0.3 * o.strength * current_A}};
       }},
      {"velocity_mismatch", velocity_mismatch}};
  return kMakers;
}

std::vector<Harmonic> harmonics_of(const json& list, const char* key) {
  std::vector<Harmonic> found;
  for (const json& one : list) {
    found.push_back({one.at("order"), one.at(key), one.at("phase_rad")});
  }
  return found;
}

void put_friction(const Effect& effect, Laws& laws) {
  const json& p = effect.parameters;
  if (p.contains("coulomb_Nm")) {
    laws.coulomb_positive_Nm = laws.coulomb_negative_Nm = p.at("coulomb_Nm");
  }
  if (p.contains("viscous_Nm_s_rad")) {
    laws.viscous_positive_Nm_s_rad = laws.viscous_negative_Nm_s_rad = p.at("viscous_Nm_s_rad");
  }
  if (effect.name == "stribeck_friction") {
    laws.breakaway_excess_Nm = p.at("breakaway_Nm").get<double>() - laws.coulomb_positive_Nm;
    laws.stribeck_velocity_rad_s = p.at("stribeck_velocity_rad_s");
  } else if (effect.name == "presliding_friction") {
    laws.presliding_Nm_rad = p.at("stiffness_Nm_rad");
  } else if (effect.name == "asymmetric_friction") {
    laws.coulomb_positive_Nm = p.at("coulomb_positive_Nm");
    laws.coulomb_negative_Nm = p.at("coulomb_negative_Nm");
    laws.viscous_positive_Nm_s_rad = p.at("viscous_positive_Nm_s_rad");
    laws.viscous_negative_Nm_s_rad = p.at("viscous_negative_Nm_s_rad");
  } else if (effect.name == "quadratic_drag") {
    laws.quadratic_Nm_s2_rad2 = p.at("drag_Nm_s2_rad2");
  } else if (effect.name == "load_dependent_friction") {
    laws.driving_coefficient = p.at("driving_coefficient");
    laws.backdriving_coefficient = p.at("backdriving_coefficient");
  } else if (effect.name == "friction_temperature") {
    laws.friction_temperature_1_K = p.at("coefficient_1_K");
  } else if (effect.name == "position_dependent_friction") {
    laws.tight_spots = harmonics_of(p.at("harmonics"), "amplitude_Nm");
  }
}

void put_electrics(const Effect& effect, Laws& laws) {
  const json& p = effect.parameters;
  if (effect.name == "torque_constant_saturation") {
    laws.saturation_current_A = p.at("saturation_current_A");
    laws.saturation_exponent = p.at("exponent");
  } else if (effect.name == "torque_constant_temperature") {
    laws.constant_temperature_1_K = p.at("coefficient_1_K");
  } else if (effect.name == "torque_constant_error") {
    laws.constant_factor = p.at("factor");
  } else if (effect.name == "torque_lag") {
    laws.lag_s = p.at("time_constant_s");
  } else if (effect.name == "voltage_sag") {
    laws.sag_ohm = p.at("resistance_ohm");
  } else if (effect.name == "winding_resistance_temperature") {
    laws.resistance_temperature_1_K = p.at("coefficient_1_K");
  } else if (effect.name == "inverter_dead_time") {
    laws.dead_time_V = p.at("voltage_V");
  }
}

/// Teeth in contact are stiff: they wind by a hundredth of the gap, and half critically damped.
void put_backlash(double gap_rad, const Plant& plant, Laws& laws) {
  laws.gap_rad = gap_rad;
  laws.stiffness_Nm_rad = 100.0 * plant.used_torque_Nm / gap_rad;
  laws.damping_Nm_s_rad = std::sqrt(laws.stiffness_Nm_rad * plant.armature_kg_m2());
}

void put_mechanics(const Effect& effect, const Plant& plant, Laws& laws) {
  const json& p = effect.parameters;
  if (effect.name == "cogging_torque") {
    laws.cogging = harmonics_of(p.at("harmonics"), "amplitude_Nm");
  } else if (effect.name == "gear_ripple") {
    const bool proportional = p.at("proportional");
    auto& list = proportional ? laws.proportional_ripple : laws.ripple;
    list = harmonics_of(p.at("harmonics"), proportional ? "amplitude_ratio" : "amplitude_Nm");
  } else if (effect.name == "backlash") {
    put_backlash(p.at("gap_rad"), plant, laws);
  } else if (effect.name == "torsional_compliance") {
    laws.stiffness_Nm_rad = p.at("stiffness_Nm_rad");
    laws.damping_Nm_s_rad = p.at("damping_Nm_s_rad");
  } else if (effect.name == "reflected_inertia") {
    laws.inertia_kg_m2 = p.at("inertia_kg_m2");
  } else if (effect.name == "gravity_imbalance") {
    laws.imbalance = {1.0, p.at("amplitude_Nm"), p.at("phase_rad")};
  } else if (effect.name == "load_inertia_error") {
    laws.load_inertia_factor = p.at("value").get<double>() / plant.load.inertia_kg_m2;
  } else if (effect.name == "load_mass_error") {
    laws.load_mass_factor = p.at("value").get<double>() / plant.load.mass_kg;
  }
}

void put_log_fault(const Effect& effect, SamplingChain& chain) {
  const json& p = effect.parameters;
  if (effect.name == "channel_delay") {
    const bool torque = p.at("channel") == "output_torque_Nm";
    chain.sensors[torque ? kTorque : kCurrent].delay_s = p.at("delay_s");
  } else if (effect.name == "torque_offset") {
    chain.sensors[kTorque].offset = p.at("value");
  } else if (effect.name == "current_offset") {
    chain.sensors[kCurrent].offset = p.at("value");
  } else {
    for (const std::size_t c : {kOutputVelocity, kMotorVelocity}) {
      chain.sensors[c].scale = p.at("scale");
      chain.sensors[c].delay_s = p.at("delay_s");
    }
  }
}

}  // namespace

std::string quantity_name(const Plant& plant, std::size_t channel) {
  static const std::vector<std::string> kNames{
      "output_position_rad",  "output_velocity_rad_s",  "motor_position_rad",
      "motor_velocity_rad_s", "motor_current_A",        "duty",
      "winding_voltage_V",    "bus_voltage_V",          "output_torque_Nm",
      "commanded_torque_Nm",  "commanded_position_rad", "winding_temperature_K",
      "case_temperature_K"};
  if (plant.load.kind == LoadKind::kLinearAxis) {
    if (channel == kOutputPosition) return "linear_position_m";
    if (channel == kOutputVelocity) return "linear_velocity_m_s";
  }
  return kNames.at(channel);
}

Effect draw_effect(const std::string& name, double strength, std::uint64_t seed, const Plant& plant,
                   const Laws& stated) {
  Draw draw(seed);
  const Order order{strength, draw, plant, stated, plant.used_torque_Nm, plant.used_speed_rad_s};
  return {name, makers().at(name)(order)};
}

bool is_log_fault(const std::string& name) {
  return name == "channel_delay" || name == "torque_offset" || name == "current_offset" ||
         name == "velocity_mismatch";
}

void apply(const Effect& effect, const Plant& plant, Laws& laws, SamplingChain& chain) {
  if (is_log_fault(effect.name)) return put_log_fault(effect, chain);
  put_friction(effect, laws);
  put_electrics(effect, laws);
  put_mechanics(effect, plant, laws);
}

void neutralise(const std::string& name, Laws& laws) {
  const Laws none;
  const auto mean = [](double& a, double& b) { a = b = 0.5 * (a + b); };
  if (name == "viscous_friction") {
    laws.viscous_positive_Nm_s_rad = laws.viscous_negative_Nm_s_rad = 0.0;
  }
  if (name == "coulomb_friction") laws.coulomb_positive_Nm = laws.coulomb_negative_Nm = 0.0;
  if (name == "stribeck_friction") laws.breakaway_excess_Nm = 0.0;
  if (name == "presliding_friction") laws.presliding_Nm_rad = 0.0;
  if (name == "asymmetric_friction") {
    mean(laws.coulomb_positive_Nm, laws.coulomb_negative_Nm);
    mean(laws.viscous_positive_Nm_s_rad, laws.viscous_negative_Nm_s_rad);
  }
  if (name == "quadratic_drag") laws.quadratic_Nm_s2_rad2 = 0.0;
  if (name == "load_dependent_friction") {
    laws.driving_coefficient = laws.backdriving_coefficient = 0.0;
  }
  if (name == "friction_temperature") laws.friction_temperature_1_K = 0.0;
  if (name == "position_dependent_friction") laws.tight_spots.clear();
  if (name == "torque_constant_saturation") laws.saturation_current_A = 0.0;
  if (name == "torque_constant_temperature") laws.constant_temperature_1_K = 0.0;
  if (name == "torque_constant_error") laws.constant_factor = 1.0;
  if (name == "torque_lag") laws.lag_s = 0.0;
  if (name == "voltage_sag") laws.sag_ohm = 0.0;
  if (name == "winding_resistance_temperature") laws.resistance_temperature_1_K = kCopper_1_K;
  if (name == "inverter_dead_time") laws.dead_time_V = 0.0;
  if (name == "cogging_torque") laws.cogging.clear();
  if (name == "gear_ripple") {
    laws.ripple.clear();
    laws.proportional_ripple.clear();
  }
  if (name == "backlash") laws.gap_rad = 0.0;
  if (name == "torsional_compliance") laws.stiffness_Nm_rad = laws.damping_Nm_s_rad = 0.0;
  if (name == "reflected_inertia") laws.inertia_kg_m2 = 0.0;
  if (name == "gravity_imbalance") laws.imbalance = none.imbalance;
  if (name == "load_inertia_error") laws.load_inertia_factor = 1.0;
  if (name == "load_mass_error") laws.load_mass_factor = 1.0;
}

}  // namespace torquewright::oracles::sampled
