// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/verdict/deed.hpp"
#include "hopper/verdict/turn.hpp"

namespace torquewright::hopper {

/// Judges which way the base faces at a position, beside how it does at a wanted one; of whole
/// turns nothing is left.
Deed heading_deed(const dynamics::Tree& tree, const Eigen::VectorXd& wanted,
                  const Eigen::VectorXd& position, double tolerance_rad);

}  // namespace torquewright::hopper
