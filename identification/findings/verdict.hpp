// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/findings/result.hpp"

namespace torquewright::identification {

/// Returns the verdict that follows from names, groups and what is left. `is_searched`: effects
/// were searched for.
Verdict verdict_of(const EquationResult& result, bool is_searched);

}  // namespace torquewright::identification
