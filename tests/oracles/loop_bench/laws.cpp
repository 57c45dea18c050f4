// SPDX-License-Identifier: Apache-2.0
// The contract's table of effects, written out once more.
#include "tests/oracles/loop_bench/laws.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::oracles::loop {
namespace {

double wave(const Law& law, double angle_rad) {
  return law.at("amplitude_Nm") * std::sin(law.at("order") * angle_rad + law.at("phase_rad"));
}

double direction_of(double value) { return static_cast<double>((value > 0.0) - (value < 0.0)); }

/// One level for both directions [Nm].
double level_Nm(const Law& law, const Moment& at) {
  if (law.name == "coulomb_friction") return law.at("coulomb_Nm");
  if (law.name == "stribeck_friction") {
    const double over = at.speed_rad_s / law.at("stribeck_velocity_rad_s");
    return law.at("coulomb_Nm") +
           (law.at("breakaway_Nm") - law.at("coulomb_Nm")) * std::exp(-over * over);
  }
  if (law.name == "load_dependent_friction") {
    const bool drives = at.load_Nm * at.speed_rad_s >= 0.0;
    return law.at(drives ? "driving_coefficient" : "backdriving_coefficient") *
           std::abs(at.load_Nm);
  }
  if (law.name == "position_dependent_friction") return wave(law, at.position_rad);
  if (law.name == "tight_spot") {
    const double over = (at.position_rad - law.at("position_rad")) / law.at("width_rad");
    return law.at("amplitude_Nm") * std::exp(-over * over);
  }
  if (law.name == "friction_by_the_clock") return law.at("slope_Nm_s") * at.time_s;
  return 0.0;
}

}  // namespace

const Law* law_named(const std::vector<Law>& laws, const std::string& name) {
  const auto found =
      std::find_if(laws.begin(), laws.end(), [&](const Law& law) { return law.name == name; });
  return found == laws.end() ? nullptr : &*found;
}

DryFriction dry_friction(const std::vector<Law>& laws, const Moment& at) {
  DryFriction sum;
  for (const Law& law : laws) {
    const bool asymmetric = law.name == "asymmetric_friction";
    const double both = asymmetric ? 0.0 : level_Nm(law, at);
    sum.forwards_Nm += asymmetric ? law.at("coulomb_positive_Nm") : both;
    sum.backwards_Nm += asymmetric ? law.at("coulomb_negative_Nm") : both;
  }
  return {std::max(sum.forwards_Nm, 0.0), std::max(sum.backwards_Nm, 0.0)};
}

double viscous_Nm_s_rad(const std::vector<Law>& laws, double speed_rad_s) {
  double sum = 0.0;
  for (const Law& law : laws) {
    if (law.name == "viscous_friction") sum += law.at("viscous_Nm_s_rad");
    if (law.name == "asymmetric_friction")
      sum += law.at(speed_rad_s >= 0.0 ? "viscous_positive_Nm_s_rad" : "viscous_negative_Nm_s_rad");
  }
  return sum;
}

double smooth_torque_Nm(const std::vector<Law>& laws, const Moment& at, double ratio) {
  const double w = at.speed_rad_s;
  double sum = -viscous_Nm_s_rad(laws, w) * w;
  for (const Law& law : laws) {
    if (law.name == "quadratic_drag") sum -= law.at("drag_Nm_s2_rad2") * w * std::abs(w);
    if (law.name == "cogging_torque") sum += wave(law, ratio * at.position_rad);
    if (law.name == "gear_ripple" || law.name == "gravity_imbalance")
      sum += wave(law, at.position_rad);
    if (law.name == "hum")
      sum += law.at("amplitude_Nm") * std::sin(law.at("rate_rad_s") * at.time_s);
  }
  return sum;
}

double effective_current_A(const std::vector<Law>& laws, double current_A) {
  double current = current_A;
  if (const Law* band = law_named(laws, "current_dead_band"))
    current = direction_of(current) * std::max(std::abs(current) - band->at("width_A"), 0.0);
  if (const Law* full = law_named(laws, "torque_constant_saturation")) {
    const double p = full->at("exponent");
    const double over = std::pow(std::abs(current) / full->at("saturation_current_A"), p);
    current /= std::pow(1.0 + over, 1.0 / p);
  }
  const Law* error = law_named(laws, "torque_constant_error");
  return error == nullptr ? current : current * error->at("factor");
}

double current_of_A(const std::vector<Law>& laws, double effective_A) {
  double current = effective_A;
  if (const Law* error = law_named(laws, "torque_constant_error")) current /= error->at("factor");
  if (const Law* full = law_named(laws, "torque_constant_saturation")) {
    const double p = full->at("exponent");
    const double over =
        std::min(std::pow(std::abs(current) / full->at("saturation_current_A"), p), 0.99);
    current /= std::pow(1.0 - over, 1.0 / p);
  }
  if (const Law* band = law_named(laws, "current_dead_band"))
    current += direction_of(current) * band->at("width_A");
  return current;
}

}  // namespace torquewright::oracles::loop
