// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "gearbox/problem.hpp"
#include "gearbox/train/mass.hpp"
#include "optimization/discrete/problem.hpp"

namespace torquewright::gearbox {

// What is compared between designs (docs/gearbox_constraints.md, "Objectives"), and the quantities
// behind bounds that could be loosened (docs/certificate.md, "Claims"), for all topologies.

/// Returns sizes and material for masses and inertias. The problem must hold face widths and
/// density.
Blank blank(const Problem& problem, const Rational& module_mm);

optimization::Goal hollow_shaft(const Problem& problem, const Rational& module_mm,
                                const optimization::Expression& sun);
optimization::Goal mass_goal(const optimization::Expression& mass_kg);
optimization::Goal inertia_goal(const optimization::Expression& inertia_kg_m2);

optimization::Loosening most_teeth(const std::string& gear, const optimization::Expression& teeth);
optimization::Loosening most_carrier_clearance(std::int64_t planet_count,
                                               const optimization::Expression& sun,
                                               const optimization::Expression& planet);
optimization::Loosening least_ring(const Rational& module_mm, const optimization::Expression& ring);
optimization::Loosening least_ratio_error(const Problem& problem,
                                          const optimization::Expression& ratio);
optimization::Loosening most_neighbour_clearance(const optimization::Expression& clearance_mm);
optimization::Loosening most_contact(const optimization::Expression& contact_ratio);
optimization::Loosening least_blank(const Problem& problem, const Rational& module_mm,
                                    const optimization::Expression& ring);

}  // namespace torquewright::gearbox
