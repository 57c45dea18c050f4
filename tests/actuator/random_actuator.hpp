// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/motor/actuator.hpp"

namespace torquewright::actuator {

struct RandomActuatorOptions {
  bool with_effects = true;
  bool regeneration_limits = true;
  bool field_weakening = false;
};

/// A plausible actuator, the same for the same seed: any convention and modulation, with or without
/// inductance, battery (sagging, with limits), gear losses and effects of the static model.
Actuator random_actuator(unsigned seed, const RandomActuatorOptions& options);

}  // namespace torquewright::actuator
