// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/check/travel_agreement.hpp"
#include "actuator/check/velocity_agreement.hpp"

namespace torquewright::actuator {

/// Outside of 1/kPlainFactor...kPlainFactor logged velocity over d(position)/dt means another unit
/// or another filter, if the two otherwise agree to kAgreement. A choice of ours.
constexpr double kPlainFactor = 1.2;
constexpr double kAgreement = 0.8;

bool is_plain_factor(double factor);

/// Returns the likely cause of a velocity that is so many times the position's slope, a clause from
/// its semicolon on; empty: no known one.
std::string cause_of_factor(double factor);

/// Returns a sentence that the velocity of a joint is not the rate of its position: from when to
/// when, the possible reason, and what can be done. Times are in the file's own clock.
std::string contradiction_sentence(const std::string& joint,
                                   const TravelContradiction& contradiction, double clock_origin_s,
                                   const VelocityAgreement& agreement);

}  // namespace torquewright::actuator
