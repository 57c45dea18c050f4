// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace torquewright::identification {

/// Where the starts of a local search ended.
struct Starts {
  std::size_t count = 0;
  std::size_t agreeing = 0;  ///< At the best value.
  /// Of those: largest less smallest value of each parameter, by its name (with its unit).
  std::vector<std::pair<std::string, double>> spread;
};

/// " Sought from 3 starts, of which 3 agree (exponent within 0.02)."
std::string sentence_of(const Starts& starts);

}  // namespace torquewright::identification
