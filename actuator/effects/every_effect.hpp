// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/effects/effect.hpp"

// One line for each effect; its file defines the constant of that name.
#define TORQUEWRIGHT_EVERY_EFFECT(effect)                                                         \
  effect(viscous_friction) effect(coulomb_friction) effect(stribeck_friction)                     \
      effect(asymmetric_friction) effect(quadratic_drag) effect(eddy_current_drag) effect(        \
          load_dependent_friction) effect(presliding_friction) effect(torque_constant_saturation) \
          effect(torque_constant_temperature) effect(friction_temperature) effect(cogging_torque) \
              effect(gear_ripple) effect(parallel_spring) effect(upper_end_stop)                  \
                  effect(lower_end_stop) effect(position_dependent_friction) effect(backlash)     \
                      effect(torsional_compliance) effect(reflected_inertia) effect(torque_lag)   \
                          effect(voltage_sag) effect(winding_resistance_temperature)              \
                              effect(inverter_dead_time) effect(torque_constant_error)            \
                                  effect(strain_wave_hysteresis) effect(power_law_drag)

namespace torquewright::actuator::effects {

#define TORQUEWRIGHT_DECLARE(name) extern const EffectKind name;
TORQUEWRIGHT_EVERY_EFFECT(TORQUEWRIGHT_DECLARE)
#undef TORQUEWRIGHT_DECLARE

}  // namespace torquewright::actuator::effects
