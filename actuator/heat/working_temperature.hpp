// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::actuator {

/// Windings and cases that work are neither colder nor hotter.
constexpr double kColdestWinding_K = 200.0;
constexpr double kHottestWinding_K = 600.0;

}  // namespace torquewright::actuator
