// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace torquewright::hopper {

/// Returns Simpson's weights of a phase's instants (knots and middles in turn: 2 n + 1), as shares
/// of its duration; they add up to 1 (docs/derivations/collocation.md eq. (1)).
std::vector<double> simpson_shares(const std::vector<double>& knots);

}  // namespace torquewright::hopper
