// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tests/oracles/sampled_bench/rigging.hpp"

namespace torquewright::oracles::sampled {

using Names = std::vector<std::string>;

/// Effects that a rig can show with rich excitation.
Names candidates(const Plant& plant);
/// What an effect needs to be seen.
Needs needs_of(const std::string& effect);
/// True where two effects change the balance in ways that good data tell apart.
bool are_separable(const std::string& one, const std::string& other);
/// Names that are right for a true effect on this rig: itself and what is exactly the same there.
Names equals_of(const Effect& effect, const Plant& plant);
/// Another effect, to be stated beside the hidden ones; empty: none fits.
std::string draw_declared(const Plant& plant, const Names& hidden, Draw& draw);

}  // namespace torquewright::oracles::sampled
