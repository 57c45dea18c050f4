// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/demand/base_residual.hpp"
#include "hopper/demand/flights.hpp"

namespace torquewright::hopper {

/// Throws io::SpecError with time, size and likely cause where the motion is impossible: a flight
/// in which momentum changes or the fall is not gravity's, a mean residual beyond its limit. Such a
/// motion cannot be judged.
void require_physical(const CheckedMotion& checked, const BaseResidual& residual,
                      const std::vector<Flight>& flights);

/// Whether it would not throw.
bool is_physical(const BaseResidual& residual, const std::vector<Flight>& flights);

}  // namespace torquewright::hopper
