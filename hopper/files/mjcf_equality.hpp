// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/files/xml.hpp"

namespace torquewright::hopper {

/// Faults for each active equality constraint that holds a part of the tree below this body.
void refuse_equalities(const Element& mujoco, const Element& top, Faults& faults);

}  // namespace torquewright::hopper
