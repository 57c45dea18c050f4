// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/check/base_residual.hpp"
#include "hopper/check/flights.hpp"

namespace torquewright::hopper {

/// Throws io::SpecError with time, size and likely cause where momentum comes from nothing: a
/// flight that turns or falls as nothing does, a mean residual beyond its limit. Such a motion
/// cannot be judged.
void require_physical(const CheckedMotion& checked, const BaseResidual& residual,
                      const std::vector<Flight>& flights);

}  // namespace torquewright::hopper
