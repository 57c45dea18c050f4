// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/findings/result.hpp"

namespace torquewright::identification {

/// Returns the parameters of an actuator's effect that the log does not determine: no larger than
/// their own standard error, where 0 means that the effect is absent.
std::vector<std::string> undetermined_parameters(const NamedEffect& named);

/// Returns the effect with 0 for its undetermined parameters, as a refined document states it.
NamedEffect with_what_is_determined(NamedEffect named);

}  // namespace torquewright::identification
