// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace torquewright::simulation {

/// Ground that is level between edges across x, the same for all y. Heights count from the ground's
/// own height; without edges it is flat. Its faces at the edges are upright.
struct GroundProfile {
  std::vector<double> edges_x_m;  ///< Ascending.
  std::vector<double> heights_m;  ///< One more than edges, from the left; none where it is flat.

  bool is_flat() const { return edges_x_m.empty(); }
  /// Returns the height of the ground at x, at an edge that of its right side.
  double height_m(double x_m) const {
    if (is_flat()) return 0.0;
    const auto right = std::upper_bound(edges_x_m.begin(), edges_x_m.end(), x_m);
    return heights_m[static_cast<std::size_t>(right - edges_x_m.begin())];
  }
};

}  // namespace torquewright::simulation
