// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Parameter kParameters[] = {
    {"stiffness_Nm_rad", 0.0, kInfinity, kInfinity,
     "Torque per twist, at the output; infinite: rigid.", true},
    {"damping_Nm_s_rad", 0.0, kInfinity, 0.0, "Torque per rate of twist, at the output."},
};

double law(const Effect& effect, const Instant& at) {
  // Rigid (infinite stiffness) there is no twist, and the torque is whatever the load takes.
  const double elastic_Nm = at.twist_rad == 0.0 ? 0.0 : effect.values[0] * at.twist_rad;
  return elastic_Nm + effect.values[1] * at.twist_rate_rad_s;
}

/// By the twist under the greatest torque.
std::vector<std::vector<double>> starts(const Ranges& ranges) {
  std::vector<std::vector<double>> all;
  for (const double twist_rad : {1e-4, 1e-3, 1e-2, 1e-1}) {
    all.push_back({ranges.torque_Nm / twist_rad, 0.0});
  }
  return all;
}

/// What turns the rotor ahead of its output as the twist T/k follows the torque: J (dT/dt)^2/(k T).
double misjudged_Nm(const Effect& effect, const MotionExtremes& motion) {
  if (motion.torque_Nm <= 0.0) return 0.0;
  const double rate_Nm_s = motion.torque_rate_Nm_s;
  const double turning_Nm =
      motion.motor_inertia_kg_m2 * rate_Nm_s * rate_Nm_s / (effect.values[0] * motion.torque_Nm);
  return std::min(turning_Nm, motion.torque_Nm);
}

double twist_rad(const Effect& effect, double torque_Nm) { return torque_Nm / effect.values[0]; }

}  // namespace

const EffectKind torsional_compliance = {
    .name = "torsional_compliance",
    .acts = Acts::kDynamics,
    .sentence =
        "Shafts and teeth twist under load: a spring and a damper between motor and output.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = nullptr,
    .state = "",
    .in_train = TrainPart::kSpring,
    .twist_rad = twist_rad,
    .stiffness_Nm_rad = [](const Effect& effect) { return effect.values[0]; },
    .starts = starts,
    .misjudged_Nm = misjudged_Nm,
};

}  // namespace torquewright::actuator::effects
