// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimization/nonlinear/program.hpp"

namespace torquewright::hopper {

inline optimization::Bounds equal_to(double value) { return {value, value}; }
inline optimization::Bounds at_least(double value) { return {.lower = value}; }
inline optimization::Bounds at_most(double value) { return {.upper = value}; }
/// Returns the bounds from minus that size to that size.
inline optimization::Bounds within(double size) { return {-size, size}; }

}  // namespace torquewright::hopper
