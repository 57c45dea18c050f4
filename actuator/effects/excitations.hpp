// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/effects/effect_properties.hpp"

// What several effects are excited by. An effect that needs a motion of its own states it in its
// file.
namespace torquewright::actuator::effects {

inline constexpr Excitation kFastMotion = {
    10,
    "motion so fast that lag times angular frequency exceeds 0.5, or a second pair of channels"};
inline constexpr Excitation kColdAndWarm = {20,
                                            "cold and warm runs in turn, the same motion in each"};
inline constexpr Excitation kCreeping = {
    30,
    "speeds down to a tenth of the Stribeck velocity, and strokes of one to five presliding "
    "lengths"};
inline constexpr Excitation kBothWaysUnderLoad = {40, "driving and back-driving at each load"};
inline constexpr Excitation kSteadySpeeds = {
    50, "steady speeds that differ by a factor of four, in both directions"};
inline constexpr Excitation kSeveralLoads = {
    60, "three loads of both signs, the largest near the peak current"};
inline constexpr Excitation kSlowTurn = {
    70, "a slow turn of the whole range, and an encoder on the motor"};
/// Excitation where no more specific one is known.
inline constexpr Excitation kMixedMotion = {
    80, "a mix of slow and fast motion in both directions under several loads"};

}  // namespace torquewright::actuator::effects
