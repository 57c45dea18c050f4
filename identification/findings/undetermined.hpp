// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/findings/result.hpp"

namespace torquewright::identification {

/// Parameters of an effect of an actuator that the log says nothing of: no larger than their own
/// standard error, where 0 is what they are without the effect.
std::vector<std::string> undetermined_parameters(const NamedEffect& named);

/// The effect with 0 in their place, as a refined document is to have it.
NamedEffect with_what_is_determined(NamedEffect named);

}  // namespace torquewright::identification
