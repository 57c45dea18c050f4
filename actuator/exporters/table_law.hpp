// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/exporters/exporter.hpp"

namespace torquewright::actuator {

/// The region as it is, for simulators that take a function: shape = speeds, then least, then
/// greatest torques, in blocks of equal length. Interpolated linearly, at rest the union of both
/// directions, beyond the ends the end rows. Conservative: both bounds drawn in by the
/// interpolation error of the table.
Shape table_shape(const Subject& subject);
TorqueLimits table_law(std::span<const double> shape, double speed_rad_s);

/// A C++ function of that name, for any simulator: std::pair<double, double> name(double).
std::string table_function(std::string_view name, std::span<const double> shape);

}  // namespace torquewright::actuator
