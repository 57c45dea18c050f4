// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/torque_limit.hpp"

#include <cmath>
#include <limits>

namespace torquewright::gearbox {
namespace {

/// The first tooth to fail when `safety` of its stresses at 1 Nm must not fall below the demand.
template <class Safety>
TorqueLimit least_limit(const StrengthCase& strength, const std::vector<ToothLoad>& at_one_Nm,
                        Safety safety) {
  TorqueLimit least;
  least.motor_Nm = std::numeric_limits<double>::infinity();
  const auto consider = [&](const ToothLoad& load, FailureMode mode, double torque_Nm) {
    if (torque_Nm < least.motor_Nm) least = {torque_Nm, 0.0, load.gear, load.mesh, mode};
  };
  for (const ToothLoad& load : at_one_Nm) {
    const double root = safety(load.root) / strength.demanded_root_safety;
    const double flank = safety(load.flank) / strength.demanded_flank_safety;
    consider(load, FailureMode::kBending, root);
    consider(load, FailureMode::kContact, flank * flank);
  }
  least.joint_Nm = least.motor_Nm * std::abs(reduction(strength.train));
  return least;
}

}  // namespace

TorqueLimits torque_limits(const StrengthCase& strength) {
  const std::vector<ToothLoad> loads = tooth_loads(strength, 1.0);
  return {least_limit(strength, loads, [](const ToothStress& s) { return s.static_safety(); }),
          least_limit(strength, loads, [](const ToothStress& s) { return s.life_safety(); })};
}

}  // namespace torquewright::gearbox
