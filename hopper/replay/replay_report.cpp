// SPDX-License-Identifier: Apache-2.0
#include "hopper/replay/replay_report.hpp"

namespace torquewright::hopper {

std::string_view name_of(EngineKind engine) {
  return engine == EngineKind::kMujoco ? "mujoco" : "own";
}

std::string_view name_of(ControllerKind controller) {
  return controller == ControllerKind::kPd ? "pd" : "lqr";
}

std::string_view name_of(DriveLimits limits) { return limits == DriveLimits::kBox ? "box" : "mor"; }

std::string_view name_of(ImpactHandling handling) {
  switch (handling) {
    case ImpactHandling::kNoDerivative:
      return "no_derivative";
    case ImpactHandling::kInvariant:
      return "invariant";
    default:
      return "default";
  }
}

}  // namespace torquewright::hopper
