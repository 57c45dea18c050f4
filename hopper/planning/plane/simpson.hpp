// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace torquewright::hopper {

/// The share of a phase's duration with which an integral over the phase counts each of its
/// instants (knots and middles in turn: 2 n + 1): of the parabola through each interval's three
/// instants. They add up to 1. docs/derivations/collocation.md eq. (1).
std::vector<double> simpson_shares(const std::vector<double>& knots);

}  // namespace torquewright::hopper
