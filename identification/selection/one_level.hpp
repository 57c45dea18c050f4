// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/findings/result.hpp"
#include "identification/signals/rows.hpp"

namespace torquewright::identification {

/// Doubts laws of speed, current or load of which the log holds one level in size: there a law that
/// is constant, or any other, does as well.
void doubt_one_level(const Rows& rows, EquationResult& result);

}  // namespace torquewright::identification
