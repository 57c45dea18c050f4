// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/programme/mesh_refinement.hpp"

namespace torquewright::hopper {

std::vector<double> refined(const std::vector<double>& knots, const std::vector<double>& error,
                            double allowed) {
  const double share = allowed / static_cast<double>(error.size());
  std::vector<double> out;
  for (std::size_t i = 0; i < error.size(); ++i) {
    out.push_back(knots[i]);
    if (error[i] > share) out.push_back(0.5 * (knots[i] + knots[i + 1]));
  }
  out.push_back(knots.back());
  return out;
}

}  // namespace torquewright::hopper
