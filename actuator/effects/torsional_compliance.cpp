// SPDX-License-Identifier: Apache-2.0
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
    .starts = starts,
};

}  // namespace torquewright::actuator::effects
