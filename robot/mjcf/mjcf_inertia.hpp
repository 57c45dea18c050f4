// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dynamics/tree.hpp"
#include "robot/mjcf/mjcf_context.hpp"

namespace torquewright::hopper {

/// What MuJoCo's compiler makes of a body's <inertial> and shapes, in the body's frame: one or the
/// other, then <compiler>'s least mass and moments, then balance. Without any: no mass.
dynamics::RigidInertia compiled_inertia(const Element& body, const std::vector<Placed>& held,
                                        const MjcfContext& context);

/// The mass of a tree of bodies.
double total_mass_kg(const Placed& body, const MjcfContext& context);

}  // namespace torquewright::hopper
