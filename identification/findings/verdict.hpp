// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/findings/result.hpp"

namespace torquewright::identification {

/// What the names, groups and what is left amount to. `is_searched`: names were looked for.
Verdict verdict_of(const EquationResult& result, bool is_searched);

}  // namespace torquewright::identification
