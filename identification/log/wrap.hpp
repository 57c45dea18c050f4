// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace torquewright::identification {

/// True if the values look like an angle that starts anew after each turn: they fill one turn, stay
/// within it, and jump by more than half of it. docs/logs.md has the rule with its numbers.
bool is_wrapped(const std::vector<double>& values, double turn);

/// Joins the turns and returns how many jumps there were. Requires is_wrapped().
std::size_t unwrap(std::vector<double>& values, double turn);

/// The first step of more than a quarter of a turn, which could be one way round or the other.
std::optional<std::size_t> find_ambiguous_step(const std::vector<double>& values, double turn);

}  // namespace torquewright::identification
