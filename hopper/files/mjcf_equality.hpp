// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/files/xml.hpp"

namespace torquewright::hopper {

/// Faults for each active equality constraint that holds a part of the tree below this body; where
/// couplings of joints and tendons may be left out, the names of those instead.
std::vector<std::string> refuse_equalities(const Element& mujoco, const Element& top,
                                           bool frees_couplings, Faults& faults);

}  // namespace torquewright::hopper
