// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identification/bench.hpp"
#include "identification/result.hpp"

namespace torquewright::identification {

/// Effects that a search found alike in this log, less those that are the same on any log of such a
/// rig; empty if nothing is left beside the member's own.
std::optional<Confounded> alike_in_log(const Bench& bench, const Group& group);

/// Effects that are the same whatever the excitation on such a rig; empty if there are none.
std::optional<Confounded> alike_on_rig(const Bench& bench, const std::string& effect);

/// Ways in which friction begins that nobody can tell apart without slow motion; empty where there
/// is some, or for an effect that it does not concern.
std::optional<Confounded> alike_when_fast(const Bench& bench, const std::vector<Signals>& signals,
                                          const std::string& effect);

}  // namespace torquewright::identification
