// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "optimization/discrete/judge.hpp"
#include "optimization/discrete/proof_tree.hpp"

namespace torquewright::optimization {

/// Shrinks the box to what the conditions, and a cost of at most `ceiling`, leave of it: each in
/// turn removes slabs at the box's sides that it refutes, until nothing moves. Every cut is
/// appended to `cuts` (in order, so that each holds on the box as it then was). Returns the
/// condition that refutes the whole box (kQuantity: the cost), if one does.
std::optional<std::size_t> propagate(const Judge& judge, double ceiling, Box& box,
                                     std::vector<Cut>& cuts);

}  // namespace torquewright::optimization
