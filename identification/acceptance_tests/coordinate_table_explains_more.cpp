// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "identification/acceptance_tests/acceptance_test.hpp"

namespace torquewright::identification {
namespace {

constexpr double kTableAhead = 0.03;  ///< By which a table may explain more than the names do.

}  // namespace

std::string coordinate_table_explains_more(const EquationFit& fit, const Selection& selection,
                                           const std::vector<ResidualStructure>& before) {
  const Equation& equation = fit.equation();
  const double explained = 1.0 - selection.model.loss / selection.empty.loss;
  for (const ResidualStructure& each : before) {
    if (each.coordinate == equation.quantity) continue;
    if (each.coordinate == "motor_current_A" && equation.target_is_motor_side) continue;
    if (each.share < explained + kTableAhead || !is_significant(each)) continue;
    return fmt::format(
        "with it {:.0f} % of the squared error is gone, and a table over {}{} alone takes {:.0f} "
        "%: "
        "so it is something else that varies with that",
        100.0 * explained, each.coordinate, each.times_direction ? " x direction" : "",
        100.0 * each.share);
  }
  return "";
}

}  // namespace torquewright::identification
