// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::actuator {

/// Range of temperatures that windings and cases have at work; others are refused. A choice of
/// ours.
constexpr double kColdestWinding_K = 200.0;
constexpr double kHottestWinding_K = 600.0;

}  // namespace torquewright::actuator
