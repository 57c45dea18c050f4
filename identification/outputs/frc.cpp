// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "actuator/effects/library.hpp"
#include "actuator/region/gear_losses.hpp"
#include "actuator/region/torque_at.hpp"
#include "actuator/region/winding.hpp"
#include "dynamics/gravity.hpp"
#include "identification/outputs/every_output.hpp"
#include "identification/rig/load_inertia.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::identification::outputs {
namespace {

constexpr int kSpeeds = 20;

/// Every drag by speed is in the line through the friction; what it cannot show is said.
std::vector<std::string_view> held() {
  std::vector<std::string_view> names = {"reflected_inertia", "torque_constant_error",
                                         "load_dependent_friction", "inverter_dead_time",
                                         "friction_temperature"};
  for (const actuator::EffectKind* each : actuator::effect_library()) {
    if (each->acts == actuator::Acts::kDrag && !each->has_harmonics) names.push_back(each->name);
  }
  return names;
}

/// Friction as a line over speed: c + b w, the mean of both directions, up to the no-load speed.
struct FrictionLine {
  double coulomb_Nm = 0.0, viscous_Nm_s_rad = 0.0, worst_Nm = 0.0;
};

double drag_at_Nm(const actuator::Actuator& actuator, double speed_rad_s) {
  double sum_Nm = 0.0;
  for (const double direction : {1.0, -1.0}) {
    actuator::Instant at;
    at.speed_rad_s = direction * speed_rad_s;
    at.direction = direction;
    at.winding_temperature_K = at.reference_temperature_K = actuator.motor.winding_temperature_K;
    sum_Nm += std::abs(actuator::drag_Nm(actuator, at));
  }
  return 0.5 * sum_Nm;
}

FrictionLine friction_line(const actuator::Actuator& actuator, double greatest_rad_s) {
  double mean_w = 0.0, mean_d = 0.0, ww = 0.0, wd = 0.0;
  for (int i = 1; i <= kSpeeds; ++i) {
    const double w = greatest_rad_s * i / kSpeeds, d = drag_at_Nm(actuator, w);
    mean_w += w / kSpeeds;
    mean_d += d / kSpeeds;
    ww += w * w / kSpeeds;
    wd += w * d / kSpeeds;
  }
  FrictionLine line;
  line.viscous_Nm_s_rad = (wd - mean_w * mean_d) / (ww - mean_w * mean_w);
  line.coulomb_Nm = mean_d - line.viscous_Nm_s_rad * mean_w;
  for (int i = 1; i <= kSpeeds; ++i) {
    const double w = greatest_rad_s * i / kSpeeds;
    line.worst_Nm = std::max(line.worst_Nm, std::abs(drag_at_Nm(actuator, w) - line.coulomb_Nm -
                                                     line.viscous_Nm_s_rad * w));
  }
  return line;
}

double dead_voltage_V(const actuator::Actuator& actuator) {
  actuator::Instant at;
  at.current_A = actuator.drive.peak_current_A;
  at.winding_temperature_K = at.reference_temperature_K = actuator.motor.winding_temperature_K;
  return std::abs(actuator::winding_voltage_change_V(actuator, at));
}

void require_volts_of_dc(const actuator::Actuator& actuator) {
  if (actuator.motor.torque_constant_convention == actuator::CurrentConvention::kDc) return;
  io::refuse("--as",
             "frc: kS, kV, kA and kG are volts of a dc winding; the actuator's "
             "torque_constant_convention must be dc");
}

std::string gravity_line(const OutputSubject& subject, double volt_per_Nm) {
  const Load& load = subject.load;
  if (load.type != LoadType::kPendulum) return "kG        0 V (the load has no gravity)\n";
  return fmt::format(
      "kG {:8.6g} V (times the cosine of the angle from the horizontal, as ArmFeedforward has it; "
      "the rig's 0 hangs down)\n",
      volt_per_Nm * load.mass_kg * dynamics::kGravity_m_s2 * load.length_m);
}

/// docs/logs.md, Outputs.
std::string write_frc(const OutputSubject& subject) {
  const actuator::Actuator& actuator = subject.actuator;
  require_volts_of_dc(actuator);
  const actuator::Winding winding = actuator::winding_of(actuator);
  const double back_emf_V_s_rad = std::abs(winding.back_emf_V_s_rad * actuator.transmission.ratio);
  const double volt_per_Nm = winding.resistance_ohm / std::abs(torque_per_ampere_Nm_A(actuator));
  const FrictionLine friction =
      friction_line(actuator, actuator.drive.bus_voltage_V / back_emf_V_s_rad);
  const double through_mesh = actuator::before_mesh_Nm(actuator, 1.0, 1.0);
  const double inertia_kg_m2 =
      actuator::reflected_inertia_kg_m2(actuator) + through_mesh * load_inertia_kg_m2(subject.load);
  const char* angle = subject.load.type == LoadType::kLinearAxis ? "m" : "rad";
  std::string text = fmt::format("kS {:8.6g} V\nkV {:8.6g} V s/{}\nkA {:8.6g} V s^2/{}\n",
                                 volt_per_Nm * friction.coulomb_Nm + dead_voltage_V(actuator),
                                 back_emf_V_s_rad + volt_per_Nm * friction.viscous_Nm_s_rad, angle,
                                 volt_per_Nm * inertia_kg_m2, angle);
  text += gravity_line(subject, volt_per_Nm * through_mesh);
  if (subject.load.type == LoadType::kDynamometer || has_joints(subject.load.type)) {
    text += "kA holds the actuator's own inertia alone: the rig states no single load\n";
  }
  if (volt_per_Nm * friction.worst_Nm > 1e-3) {
    text += fmt::format("friction is a curve: this line is off by {:.3g} V at most\n",
                        volt_per_Nm * friction.worst_Nm);
  }
  if (through_mesh != 1.0) {
    text += "losses in proportion to the load are those of driving; braking takes less\n";
  }
  const std::string left = others(actuator, held());
  if (!left.empty()) text += "without a counterpart: " + left + "\n";
  return text;
}

}  // namespace

const Output frc = {"frc", "WPILib's feedforward: kS, kV, kA, kG",
                    "https://docs.wpilib.org/en/stable/docs/software/advanced-controls/controllers/"
                    "feedforward.html",
                    write_frc};

}  // namespace torquewright::identification::outputs
