// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hopper/planning/search/plan.hpp"

namespace torquewright::hopper {

/// Returns the phase of the longest flight; null where nothing flies.
const PlannedPhase* longest_flight(const PlannedMotion& motion);

/// Returns how far the centre of mass rises over its height at take-off, in the longest flight that
/// `hopper check` found. None without a check or a flight.
std::optional<double> rise_of(const PlanResult& result);

}  // namespace torquewright::hopper
