// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "actuator/region/torque_at.hpp"
#include "actuator/region/winding.hpp"
#include "identification/outputs/every_output.hpp"
#include "io/faults/json_text.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::identification::outputs {
namespace {

using nlohmann::ordered_json;

constexpr double kGaussian = 2.0;  ///< The exponent of stribeck_friction's own law.
constexpr double kSame = 1e-6;     ///< Relative.

constexpr std::array<std::string_view, 7> kHeldByBam = {
    "coulomb_friction",      "viscous_friction",        "stribeck_friction",  "reflected_inertia",
    "torque_constant_error", "load_dependent_friction", "asymmetric_friction"};

/// Friction over the torque on the load, driving and driven back: stated efficiencies and
/// load_dependent_friction together.
struct LoadFriction {
  double driving = 0.0, backdriving = 0.0;
  bool is_none() const { return driving == 0.0 && backdriving == 0.0; }
};

LoadFriction load_friction(const actuator::Actuator& actuator) {
  const double k_d = stated(actuator, "load_dependent_friction", "driving_coefficient");
  const double k_b = stated(actuator, "load_dependent_friction", "backdriving_coefficient");
  return {(1.0 + k_d) / actuator.transmission.forward_efficiency - 1.0,
          1.0 - actuator.transmission.backward_efficiency * (1.0 - k_b)};
}

double mean_of_both(const actuator::Actuator& actuator, const std::string& what,
                    const std::string& unit) {
  return 0.5 * (stated(actuator, "asymmetric_friction", what + "_positive_" + unit) +
                stated(actuator, "asymmetric_friction", what + "_negative_" + unit));
}

void add_stribeck(const actuator::Actuator& actuator, ordered_json& json) {
  const double coulomb_Nm = stated(actuator, "stribeck_friction", "coulomb_Nm");
  const double breakaway_Nm = stated(actuator, "stribeck_friction", "breakaway_Nm");
  const double speed_rad_s = stated(actuator, "stribeck_friction", "stribeck_velocity_rad_s");
  json["friction_stribeck"] = breakaway_Nm - coulomb_Nm;
  json["dtheta_stribeck"] = speed_rad_s > 0.0 ? speed_rad_s : 1.0;
  json["alpha"] = kGaussian;
}

/// |e external - m motor| is to be K |tau|: motor is (1 + K_d) tau driving, (1 - K_b) tau driven
/// back, external -tau. So e + m (1 + K_d) = K_d and e + m (1 - K_b) = K_b.
void add_load_friction(const LoadFriction& friction, ordered_json& json) {
  const double motor =
      (friction.driving - friction.backdriving) / (friction.driving + friction.backdriving);
  json["load_friction_motor"] = motor;
  json["load_friction_external"] = friction.driving - motor * (1.0 + friction.driving);
  json["load_friction_motor_stribeck"] = 0.0;
  json["load_friction_external_stribeck"] = 0.0;
}

std::vector<std::string> notes_of(const actuator::Actuator& actuator, const ordered_json& json) {
  std::vector<std::string> notes;
  const std::string left = others(actuator, kHeldByBam);
  if (!left.empty()) notes.push_back("without a counterpart: " + left);
  if (stated(actuator, "asymmetric_friction", "coulomb_positive_Nm") !=
      stated(actuator, "asymmetric_friction", "coulomb_negative_Nm")) {
    notes.emplace_back("friction differs by direction; the mean of both is written");
  }
  const double back_emf =
      actuator::winding_of(actuator).back_emf_V_s_rad * actuator.transmission.ratio;
  if (std::abs(back_emf - json["kt"].get<double>()) > kSame * std::abs(back_emf)) {
    notes.emplace_back("BAM's kt is torque constant and back-EMF in one; these differ here");
  }
  if (json.value("load_friction_motor", 0.0) < 0.0 ||
      json.value("load_friction_external", 0.0) < 0.0) {
    notes.emplace_back(
        "a load friction is negative, outside of what BAM's fit allows: driving and back-driving "
        "differ in a way that its own bounds exclude");
  }
  return notes;
}

/// docs/logs.md, Outputs.
std::string write_bam(const OutputSubject& subject) {
  const actuator::Actuator& actuator = subject.actuator;
  if (actuator.motor.torque_constant_convention != actuator::CurrentConvention::kDc) {
    io::refuse("--as",
               "bam: kt and R are those of a dc winding; the actuator's "
               "torque_constant_convention must be dc");
  }
  const LoadFriction load = load_friction(actuator);
  const bool has_stribeck = stated(actuator, "stribeck_friction", "breakaway_Nm") > 0.0;
  ordered_json json;
  json["model"] = !load.is_none() ? "m5" : has_stribeck ? "m2" : "m1";
  json["actuator"] = actuator.name;
  json["kt"] = torque_per_ampere_Nm_A(actuator);
  json["R"] = actuator::winding_of(actuator).resistance_ohm;
  json["armature"] = actuator::reflected_inertia_kg_m2(actuator);
  json["q_offset"] = 0.0;
  json["friction_base"] = stated(actuator, "coulomb_friction", "coulomb_Nm") +
                          stated(actuator, "stribeck_friction", "coulomb_Nm") +
                          mean_of_both(actuator, "coulomb", "Nm");
  json["friction_viscous"] = stated(actuator, "viscous_friction", "viscous_Nm_s_rad") +
                             mean_of_both(actuator, "viscous", "Nm_s_rad");
  if (has_stribeck || !load.is_none()) add_stribeck(actuator, json);
  if (!load.is_none()) add_load_friction(load, json);
  const std::vector<std::string> notes = notes_of(actuator, json);
  if (!notes.empty()) json["notes"] = notes;
  return io::json_text(json, 1);
}

}  // namespace

const Output bam = {"bam", "Parameters of Rhoban's bam friction models (m1, m2, m5), as JSON",
                    "https://github.com/Rhoban/bam/blob/main/bam/model.py", write_bam};

}  // namespace torquewright::identification::outputs
