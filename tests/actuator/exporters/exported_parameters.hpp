// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "actuator/exporters/exporter.hpp"

namespace torquewright::actuator {

/// Reads an exported file as its simulator would, by another way than it was written, and returns
/// that simulator's law with the numbers that stand there. Throws std::runtime_error for a file
/// that lacks a field.
std::function<TorqueLimits(double speed_rad_s)> law_of_file(const std::string& format,
                                                            const std::string& text);

}  // namespace torquewright::actuator
