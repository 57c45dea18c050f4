// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/plane/simpson.hpp"

namespace torquewright::hopper {

std::vector<double> simpson_shares(const std::vector<double>& knots) {
  std::vector<double> shares(2 * knots.size() - 1, 0.0);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double sixth = (knots[i + 1] - knots[i]) / 6.0;
    shares[2 * i] += sixth;
    shares[2 * i + 1] += 4.0 * sixth;
    shares[2 * i + 2] += sixth;
  }
  return shares;
}

}  // namespace torquewright::hopper
