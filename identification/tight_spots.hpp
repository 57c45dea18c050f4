// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "identification/dictionary.hpp"

namespace torquewright::identification {

/// False where friction that varies with position would push: dry friction is nowhere less than
/// nothing, so no harmonic of it is stronger than its mean, stated and fitted. `first`: place of
/// the first member's coefficients among the values.
bool are_tight_spots_possible(const Dictionary& dictionary, const std::vector<std::size_t>& members,
                              std::size_t first, const Eigen::VectorXd& values);

}  // namespace torquewright::identification
