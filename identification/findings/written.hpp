// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/findings/result.hpp"

namespace torquewright::identification {

/// Returns the effects of the actuator that a refined document holds: those that are certain, and
/// of a group that this log does not tell apart the one that was named, where every member is the
/// actuator's, so that one of them acts, and nothing speaks against the name
/// (docs/decisions/0025-what-no-log-tells-is-not-written.md). Nothing of an equation that is not
/// explained, or whose runs are not of one rig.
std::vector<const NamedEffect*> written_of(const EquationResult& result);

/// Returns the effects that this log does not tell from one that was named, in the order of their
/// groups; none where it is certain.
std::vector<std::string> undecided_with(const EquationResult& result, const std::string& effect);

/// Whether the equation can be trusted to say what a refined document should hold.
bool is_trusted(const EquationResult& equation);

}  // namespace torquewright::identification
