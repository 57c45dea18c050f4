// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace torquewright::identification {

/// Summary of where the starts of a local search ended.
struct Starts {
  std::size_t count = 0;
  std::size_t agreeing = 0;  ///< Number of starts that ended at the best value.
  /// Largest less smallest value of each parameter among the agreeing starts, by its name (with its
  /// unit).
  std::vector<std::pair<std::string, double>> spread;
};

/// Returns a sentence: " Sought from 3 starts, of which 3 agree (exponent within 0.02)."
std::string sentence_of(const Starts& starts);

}  // namespace torquewright::identification
