// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "gearbox/proof/tree/account.hpp"

namespace torquewright::gearbox::proof {

/// Checks that `nodes`, the proof tree in preorder, shows the claim for every point of the root
/// box. Stops at the first fault: what follows it has no meaning.
void check_tree(const Claim& claim, const Alternative& alternative, const Json& nodes,
                const std::string& place, Account& account);

}  // namespace torquewright::gearbox::proof
