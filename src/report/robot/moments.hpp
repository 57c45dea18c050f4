// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/demand/flights.hpp"

namespace torquewright::report {

/// A sample to be drawn, and whether it lies in a flight.
struct Moment {
  Eigen::Index sample = 0;
  bool is_in_flight = false;
};

/// Returns so many moments in order of time. Half of them are spread over the flights, the other
/// half over the time between: what a jump is about is short. Without flights, or with nothing but
/// flight, all are spread over the motion.
std::vector<Moment> moments_of(const hopper::Motion& motion,
                               const std::vector<hopper::Flight>& flights, int count);

}  // namespace torquewright::report
