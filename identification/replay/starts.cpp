// SPDX-License-Identifier: Apache-2.0
#include "identification/replay/starts.hpp"

#include <fmt/format.h>

namespace torquewright::identification {

std::string sentence_of(const Starts& starts) {
  std::string within;
  for (const auto& [name, spread] : starts.spread) {
    within += fmt::format("{}{} within {:.2g}", within.empty() ? "" : ", ", name, spread);
  }
  return fmt::format(" Sought from {} starts, of which {} {}{}.", starts.count, starts.agreeing,
                     starts.agreeing == 1 ? "found the best value" : "agree",
                     starts.agreeing > 1 && !within.empty() ? " (" + within + ")" : "");
}

}  // namespace torquewright::identification
