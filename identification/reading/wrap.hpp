// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "identification/log/largest_values.hpp"

namespace torquewright::identification {

/// Whether values look like an angle that starts anew after each turn: they fill one turn, stay
/// within it, and jump by more than half of it. docs/logs.md has the rule with its numbers.
bool is_wrapped(const std::vector<double>& values, double turn);

/// Joins the turns and returns the samples at which they began anew. Requires is_wrapped().
std::vector<std::size_t> unwrap(std::vector<double>& values, double turn);

/// Finds the first step of more than a quarter of a turn, whose direction cannot be told.
std::optional<std::size_t> find_ambiguous_step(const std::vector<double>& values, double turn);

/// Decides the same as is_wrapped() for values that come in parts.
class WrapEvidence {
 public:
  WrapEvidence(std::size_t most_values, double turn);
  void add(const std::vector<double>& values);
  bool is_wrapped() const;

 private:
  double turn_;
  double previous_ = 0.0;
  bool jumps_ = false;
  LargestValues upper_, lower_;
};

}  // namespace torquewright::identification
