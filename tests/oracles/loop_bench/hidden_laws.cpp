// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/loop_bench/hidden_laws.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace torquewright::oracles::loop {
namespace {

using std::numbers::pi;
using Names = std::vector<std::string>;

/// A speed in the middle of what the rigs do [rad/s].
constexpr double kUsualSpeed_rad_s = 4.0;

void leave_out(const std::string& name, Drive& drive) {
  std::erase_if(drive.stated, [&](const Law& law) { return law.name == name; });
}

Law wave_of(const std::string& name, double order, double torque_Nm, Draws& draws) {
  return {name,
          {{"order", order}, {"amplitude_Nm", torque_Nm}, {"phase_rad", draws.uniform(-pi, pi)}}};
}

Law friction_of(const std::string& name, double torque_Nm, Draws& draws, Drive& drive) {
  if (name != "viscous_friction") leave_out("coulomb_friction", drive);
  if (name == "viscous_friction" || name == "asymmetric_friction")
    leave_out("viscous_friction", drive);
  if (name == "coulomb_friction") return {name, {{"coulomb_Nm", torque_Nm}}};
  if (name == "viscous_friction")
    return {name, {{"viscous_Nm_s_rad", torque_Nm / kUsualSpeed_rad_s}}};
  if (name == "stribeck_friction")
    return {name,
            {{"coulomb_Nm", torque_Nm},
             {"breakaway_Nm", torque_Nm * draws.uniform(1.3, 2.2)},
             {"stribeck_velocity_rad_s", draws.log_uniform(0.1, 1.0)}}};
  const double viscous = torque_Nm / kUsualSpeed_rad_s;
  return {name,
          {{"coulomb_positive_Nm", torque_Nm * draws.uniform(1.1, 1.6)},
           {"coulomb_negative_Nm", torque_Nm * draws.uniform(0.5, 0.9)},
           {"viscous_positive_Nm_s_rad", viscous * draws.uniform(0.2, 1.0)},
           {"viscous_negative_Nm_s_rad", viscous * draws.uniform(0.2, 1.0)}}};
}

Law wave_law(const std::string& name, double torque_Nm, Draws& draws, Drive& drive) {
  if (name == "cogging_torque")
    return wave_of(name, draws.one_of(std::vector<double>{4, 6, 7, 12, 14, 24}), torque_Nm, draws);
  if (name == "gravity_imbalance") return wave_of(name, 1.0, torque_Nm, draws);
  if (name == "gear_ripple")
    return wave_of(name, draws.one_of(std::vector<double>{5, 8, 11, 17, 30}), torque_Nm, draws);
  leave_out("coulomb_friction",
            drive);  // position_dependent_friction: about a level that is stated
  drive.stated.push_back({"coulomb_friction", {{"coulomb_Nm", 1.5 * torque_Nm}}});
  return wave_of(name, draws.one_of(std::vector<double>{4, 5, 8, 11}), torque_Nm, draws);
}

Law motor_law(const std::string& name, double share, double scale_Nm, Draws& draws,
              const Drive& drive) {
  if (name == "torque_constant_error")
    return {name, {{"factor", draws.chance(0.5) ? 1.0 + share : 1.0 / (1.0 + share)}}};
  if (name == "reflected_inertia")
    return {name, {{"inertia_kg_m2", share * drive.reflected_inertia_kg_m2() * 8.0}}};
  if (name == "torque_lag") return {name, {{"time_constant_s", 0.001 + 0.08 * share}}};
  if (name == "inverter_dead_time") return {name, {{"voltage_V", share * drive.bus_V * 0.1}}};
  if (name == "voltage_sag")
    return {name, {{"resistance_ohm", share * drive.bus_V / drive.peak_current_A}}};
  // Of saturation the share is what is lost at the usual current.
  const double usual_A = scale_Nm / drive.torque_per_current_Nm_A();
  const double exponent = draws.uniform(1.6, 2.6);
  return {name,
          {{"saturation_current_A", usual_A * std::pow(exponent * share, -1.0 / exponent)},
           {"exponent", exponent}}};
}

Law law_outside(const std::string& name, double torque_Nm, double middle_rad, Draws& draws,
                const Drive& drive) {
  if (name == "tight_spot")
    return {name,
            {{"amplitude_Nm", torque_Nm},
             {"position_rad", middle_rad + draws.uniform(-0.2, 0.2)},
             {"width_rad", draws.uniform(0.05, 0.15)}}};
  if (name == "friction_by_the_clock") return {name, {{"slope_Nm_s", torque_Nm / 5.0}}};
  if (name == "hum")
    return {name, {{"amplitude_Nm", torque_Nm}, {"rate_rad_s", draws.uniform(9.0, 30.0)}}};
  return {name, {{"width_A", torque_Nm / drive.torque_per_current_Nm_A()}}};
}

bool is_one_of(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Names that no log of such a rig tells apart from this one (the contract's section 1.3).
Names right_names(const std::string& name, const Situation& it, const Drive& drive) {
  const bool turns_freely = it.rig.shape == "flywheel";
  if (name == "reflected_inertia") return {name, "load_inertia_error"};
  if (name == "torque_constant_error")
    return turns_freely ? Names{name, "load_inertia_error", "reflected_inertia"}
                        : Names{name, "load_mass_error"};
  if (name == "current_offset" || name == "asymmetric_friction")
    return {name, "current_offset", "torque_offset", "asymmetric_friction"};
  if (name == "torque_lag" && law_named(drive.hidden, name)->at("time_constant_s") < 0.005)
    return {name, "channel_delay"};
  return {name};
}

}  // namespace

Names names_for(const Rig& rig, bool logs_voltage) {
  Names names{"coulomb_friction",
              "viscous_friction",
              "stribeck_friction",
              "asymmetric_friction",
              "quadratic_drag",
              "load_dependent_friction",
              "position_dependent_friction",
              "gear_ripple",
              "cogging_torque"};
  if (rig.shape == "flywheel") names.push_back("gravity_imbalance");
  const Names more = logs_voltage ? Names{"voltage_sag", "inverter_dead_time", "voltage_sag"}
                                  : Names{"torque_constant_saturation",
                                          "torque_constant_error",
                                          "reflected_inertia",
                                          "torque_lag",
                                          "current_offset",
                                          "channel_delay"};
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

Names names_outside() {
  return {"tight_spot", "friction_by_the_clock", "hum", "current_dead_band"};
}

void hide(const std::string& name, double share, double scale_Nm, Draws& draws, Situation& it) {
  static const Names kFrictions{"coulomb_friction", "viscous_friction", "stribeck_friction",
                                "asymmetric_friction"};
  static const Names kWaves{"cogging_torque", "gravity_imbalance", "gear_ripple",
                            "position_dependent_friction"};
  Drive& drive = it.rig.drives[it.joint];
  const double torque_Nm = share * scale_Nm;
  if (name == "current_offset") {
    it.sensing.current_offset_A = torque_Nm / drive.torque_per_current_Nm_A();
  } else if (name == "channel_delay") {
    it.sensing.current_delay_s = std::max(std::round(80.0 * share), 1.0) * 5e-4;
  } else if (is_one_of(kFrictions, name)) {
    drive.hidden.push_back(friction_of(name, torque_Nm, draws, drive));
  } else if (is_one_of(kWaves, name)) {
    drive.hidden.push_back(wave_law(name, torque_Nm, draws, drive));
  } else if (name == "quadratic_drag") {
    drive.hidden.push_back(
        {name, {{"drag_Nm_s2_rad2", torque_Nm / (kUsualSpeed_rad_s * kUsualSpeed_rad_s)}}});
  } else if (name == "load_dependent_friction") {
    const double driving = std::min(share * draws.uniform(0.7, 1.3), 0.4);
    drive.hidden.push_back({name,
                            {{"driving_coefficient", driving},
                             {"backdriving_coefficient", driving * draws.uniform(0.7, 1.2)}}});
  } else if (is_one_of(names_outside(), name)) {
    drive.hidden.push_back(law_outside(
        name, torque_Nm, it.runs.front().references[it.joint].middle_rad, draws, drive));
  } else {
    drive.hidden.push_back(motor_law(name, share, scale_Nm, draws, drive));
  }
  it.hidden.push_back(name);
  it.accept.push_back(right_names(name, it, drive));
}

}  // namespace torquewright::oracles::loop
