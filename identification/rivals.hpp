// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/trials.hpp"

namespace torquewright::identification {

/// The member's effect and, behind it, those that explain as much in its place: rivals that the log
/// does not refute. docs/derivations/identification.md section 4. Requires a valid model.
Group group_of(const Trials& trials, const Fit& model, std::size_t place);

}  // namespace torquewright::identification
