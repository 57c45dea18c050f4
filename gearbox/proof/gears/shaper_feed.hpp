// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "gearbox/problem.hpp"

namespace torquewright::gearbox::proof {

/// The fewest teeth of a ring into which the stated shaper can be fed radially. Requires its teeth.
std::int64_t least_fed_ring(const Problem& problem);

}  // namespace torquewright::gearbox::proof
