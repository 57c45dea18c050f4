// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/demand/checked_motion.hpp"
#include "hopper/policy/policy_document.hpp"

namespace torquewright::hopper {

/// How a policy is used now.
struct PolicyUse {
  bool in_plane = false;            ///< Whether the robot is held to the plane.
  std::string limits;               ///< "mor" or "box".
  std::vector<std::string> sha256;  ///< Of the robot's documents.
};

/// What a reader must know of it: limits or documents that are not those that it was trained with.
std::vector<Finding> policy_findings(const PolicyDocument& document, const PolicyUse& use);

}  // namespace torquewright::hopper
