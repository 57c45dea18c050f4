// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/clip.hpp"
#include "actuator/exporters/exporter.hpp"

namespace torquewright::actuator {

/// Laws of three numbers: stall torque, no-load speed and greatest torque.
inline constexpr ShapeParameter kLineParameters[] = {
    {"stall_torque_Nm"}, {"no_load_speed_rad_s"}, {"greatest_torque_Nm"}};

Parallelogram parallelogram_of(std::span<const double> shape);

/// The parallelogram of the motor alone: the region itself where nothing but its voltage, its
/// resistance and its current limits it.
Shape line_start(const Subject& subject);

/// The parallelogram; past its overspeed the greatest torque against the motion.
TorqueLimits line_law(std::span<const double> shape, double speed_rad_s);

}  // namespace torquewright::actuator
