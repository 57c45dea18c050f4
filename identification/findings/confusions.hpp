// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/preparation/preparation.hpp"

namespace torquewright::identification {

/// Returns the effects that are the same column whatever the excitation on such a rig, the
/// preferred name first; only the effect itself if there are none.
std::vector<std::string> exact_identities(const Bench& bench, const std::string& effect);

/// Returns a sentence that says what would tell these effects apart.
std::string separated_by(const Bench& bench, const std::vector<std::string>& effects);

/// Returns a sentence that says what follows for the region from each reading of an exact group.
/// `named` is the effect that was taken.
std::string consequence(const std::string& named, const std::vector<std::string>& effects);

}  // namespace torquewright::identification
