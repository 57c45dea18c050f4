// SPDX-License-Identifier: Apache-2.0
#include "hopper/verdict/heading_deed.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace torquewright::hopper {

Deed heading_deed(const dynamics::Tree& tree, const Eigen::VectorXd& wanted,
                  const Eigen::VectorXd& position, double tolerance_rad) {
  Deed deed;
  deed.name = "heading";
  deed.unit = "rad";
  deed.done = attitude_error(tree, wanted, position).heading_rad;
  deed.off = std::abs(deed.done);
  deed.tolerance = tolerance_rad;
  deed.is_done = deed.off <= deed.tolerance;
  deed.sentence = fmt::format("it faces {:.0f} degrees from where it is to",
                              std::round(deed.off * 180.0 / std::numbers::pi));
  return deed;
}

}  // namespace torquewright::hopper
