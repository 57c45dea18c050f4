// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/constraints/site.hpp"

namespace torquewright::hopper {

/// Of the points that touch the least, the planning margin taken off.
double friction_of(const Site& site);

/// Affine rows of forces or impulses of the stance: friction, and of a flat one that each end bears
/// `edge` of the load at least. docs/derivations/collocation.md eqs. (6), (7).
void add_cone(const Site& site, std::string_view name, int forces, double scale, double edge,
              optimization::Program& program);

}  // namespace torquewright::hopper
