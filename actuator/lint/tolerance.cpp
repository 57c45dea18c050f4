// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/tolerance.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::actuator::lint {
namespace {

constexpr double kConstant = 0.1;       // of a catalogue's constants, either way
constexpr double kOfEachStage = 0.9;    // least efficiency of one stage of gears
constexpr double kRatioOfStage = 10.0;  // greatest of one planetary stage
constexpr double kUnsaturated = 0.8;    // least part of a peak torque that saturation leaves

/// An efficiency of exactly 1, or one that is marked as assumed, is not known.
bool is_efficiency_known(const Actuator& document) {
  const bool is_assumed =
      std::any_of(document.assumed.begin(), document.assumed.end(), [](const auto& pointer) {
        return pointer == "/gearbox" || pointer == "/gearbox/forward_efficiency";
      });
  return !is_assumed && document.transmission.forward_efficiency != 1.0;
}

/// What gears of unknown efficiency leave at least of a torque at the joint.
double least_after_gears(const Actuator& document) {
  const bool is_behind_gears = document.datasheet && document.datasheet->joint_side;
  const double ratio = std::abs(document.transmission.ratio);
  if (!is_behind_gears || ratio == 1.0 || is_efficiency_known(document)) return 1.0;
  const double stages = std::ceil(std::log(std::max(ratio, 1.0 / ratio)) / std::log(kRatioOfStage));
  return std::pow(kOfEachStage, stages) / std::min(1.0, document.transmission.forward_efficiency);
}

}  // namespace

Tolerance catalogue(const Actuator& /*document*/) { return {1.0 - kConstant, 1.0 + kConstant}; }

Tolerance rated_torques(const Actuator& document) {
  Tolerance tolerance = catalogue(document);
  tolerance.least *= std::min(1.0, least_after_gears(document));
  return tolerance;
}

Tolerance peak_torques(const Actuator& document) {
  Tolerance tolerance = rated_torques(document);
  tolerance.least *= kUnsaturated;
  return tolerance;
}

}  // namespace torquewright::actuator::lint
