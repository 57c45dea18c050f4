// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/findings/result.hpp"

namespace torquewright::identification {

/// The one verdict that those on several equations come to: what is known to be wrong weighs more
/// than what cannot be told, that more than what is explained. Without equations: cannot tell.
Verdict verdict_of_all(const std::vector<const EquationResult*>& equations);

/// What the equations of one joint come to.
struct JointVerdict {
  std::string joint;
  Verdict verdict = Verdict::kCannotTell;
  std::vector<const EquationResult*> equations;  ///< Pointers into what was given.
};

/// The joints in the order of their equations; none where these have no joint's name.
std::vector<JointVerdict> joint_verdicts(const std::vector<EquationResult>& equations);

}  // namespace torquewright::identification
