// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/exporters/exporter.hpp"

namespace torquewright::actuator {

/// The shape of a law that fits the subject's region as it asks. `start` is returned as it is where
/// it is the region to within rounding; all its numbers must be positive. A conservative fit ends
/// by scaling the law about the origin until it lies inside at every speed looked at (kFitSpeeds on
/// each side of rest and every corner of the table).
Shape fitted(const Subject& subject, const Exporter& exporter, const Shape& start);
constexpr int kFitSpeeds = 2000;

}  // namespace torquewright::actuator
