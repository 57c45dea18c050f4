// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "identification/acceptance_tests/acceptance_test.hpp"

namespace torquewright::identification {
namespace {

constexpr double kMostLeftAlongOwn = 0.3;
constexpr double kMostLeftAlongPair = 0.15;  ///< Of two laws of the torque constant together.
constexpr double kMostLeftOfOwn = 0.15;  ///< What is left along it over what the name takes away.

/// The coordinates along which a law would be wrong if it were the wrong law.
std::vector<std::string> own_coordinates(const std::string& effect) {
  if (effect == "torque_constant_error" || effect == "torque_constant_saturation" ||
      effect == "load_dependent_friction") {
    return {"load_torque_Nm", "motor_current_A"};
  }
  if (effect == "viscous_friction" || effect == "quadratic_drag") return {"output_velocity_rad_s"};
  if (effect == "gear_ripple" || effect == "gravity_imbalance" ||
      effect == "position_dependent_friction") {
    return {"output_position_rad"};
  }
  if (effect == "cogging_torque") return {"motor_position_rad"};
  return {};
}

/// Two of them together can follow a dead zone of the current's sensor.
bool is_of_torque_constant(const std::string& effect) {
  return effect == "torque_constant_error" || effect == "torque_constant_saturation";
}

bool has_pair_of_torque_constant(const Fitter& fitter, const Fit& model) {
  const auto count =
      std::count_if(model.members.begin(), model.members.end(), [&](std::size_t member) {
        return is_of_torque_constant(fitter.dictionary().variants[member].effect);
      });
  return count > 1;
}

/// What the member takes away; at least nothing.
double own_gain(const Fitter& fitter, const Fit& model, std::size_t member) {
  Members members = model.members;
  members.erase(members.begin() + static_cast<std::ptrdiff_t>(member));
  const Fit without = fitter.fit_unlimited(members);
  return without.is_valid ? std::max(0.0, without.loss - model.loss) : 0.0;
}

}  // namespace

std::string residual_along_own_coordinate(const EquationFit& fit, const Fit& model,
                                          std::size_t member,
                                          const std::vector<ResidualStructure>& left) {
  if (is_nearly_noise(fit, model)) return "";
  const Fitter& fitter = fit.fitter();
  const std::string& effect = fitter.dictionary().variants[model.members[member]].effect;
  const std::vector<std::string> own = own_coordinates(effect);
  const bool is_pair = is_of_torque_constant(effect) && has_pair_of_torque_constant(fitter, model);
  const double most = is_pair ? kMostLeftAlongPair : kMostLeftAlongOwn;
  for (const ResidualStructure& each : left) {
    if (std::find(own.begin(), own.end(), each.coordinate) == own.end()) continue;
    if (each.share < most || !is_significant(each)) continue;
    // A law that took nearly all of what varies along its coordinate is not the wrong one: what
    // something else leaves may vary there too.
    const bool is_cleared =
        each.share * model.loss < kMostLeftOfOwn * own_gain(fitter, model, member);
    if (is_cleared && !is_of_torque_constant(effect)) continue;
    return fmt::format("{:.0f} % of what is left varies with {}, which it should have explained",
                       100.0 * each.share, each.coordinate);
  }
  return "";
}

}  // namespace torquewright::identification
