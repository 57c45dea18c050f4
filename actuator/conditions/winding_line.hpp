// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "actuator/conditions/region_grid.hpp"

namespace torquewright::actuator {

/// A region that is one line of a winding and the current's limit, whatever voltage V and
/// temperature T: the torque lies between +-`greatest_Nm` and, with q = `torque_Nm_V` /
/// (1 + `per_K` (T - `at_K`)), between q (-V - `V_s_rad` speed) and q (V - `V_s_rad` speed).
struct WindingLine {
  double torque_Nm_V = 0.0;
  double V_s_rad = 0.0;
  double greatest_Nm = 0.0;
  double per_K = 0.0;
  double at_K = 0.0;
};

/// The line that a grid's own numbers lie on, all of them, within roundings; nothing where one is
/// off it. Requires a grid that has not been drawn in.
std::optional<WindingLine> winding_line(const RegionGrid& grid);

}  // namespace torquewright::actuator
