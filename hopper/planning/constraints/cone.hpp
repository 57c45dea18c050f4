// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/constraints/site.hpp"

namespace torquewright::hopper {

/// Returns the least coefficient of friction of the points that touch, the planning margin taken
/// off.
double friction_of(const Site& site);

/// Whether the phase's end lets a point go: the load has to get to the edge there.
bool tips(const Site& site);

/// Returns what each end of the sole bears at least, as a share of the load, at a share of the
/// phase (0 to 1): the planning margin, less where the foot is about to tip.
double edge_at(const Site& site, double share);

/// Affine rows of forces or impulses of the stance: friction, and of a flat one that each end bears
/// `edge` of the load at least. docs/derivations/collocation.md eqs. (6), (7).
void add_cone(const Site& site, std::string_view name, int forces, double scale, double edge,
              optimization::Program& program);

}  // namespace torquewright::hopper
