// SPDX-License-Identifier: Apache-2.0
#include "identification/log/spread_runs.hpp"

namespace torquewright::identification {

std::vector<std::size_t> spread_runs(const Runs& runs) {
  std::vector<std::size_t> chosen;
  const double share = runs.is_in_memory() ? 1.0
                                           : static_cast<double>(runs.most_rows_in_memory()) /
                                                 static_cast<double>(runs.rows());
  // Each run adds its share of rows to what is due, and is taken once that reaches half of its own:
  // so that neither the beginning nor the end is favoured.
  double due = 0.0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto rows = static_cast<double>(runs.head(i).samples);
    due += share * rows;
    if (!runs.is_in_memory() && due < 0.5 * rows) continue;
    due -= rows;
    chosen.push_back(i);
  }
  return chosen;
}

}  // namespace torquewright::identification
