// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "gearbox/constraints/condition.hpp"
#include "gearbox/train/gear_train.hpp"

namespace torquewright::gearbox {

// The involute of a root goes as far as the mate's tip needs it: docs/gearbox_constraints.md,
// "Cutters". Lengths in modules.

/// Makes the condition that the hob's tip radius, stated or 0, is at most `largest`.
DesignCondition hob_condition(std::string_view mesh, const Rational& module_mm, double largest,
                              const std::optional<Rational>& stated);

/// Makes the same condition for a ring's shaper with so many teeth.
DesignCondition shaper_condition(std::string_view mesh, const Rational& module_mm, double largest,
                                 const std::optional<Rational>& stated, double shaper_teeth);

/// The fewest teeth of a ring without profile shift into which the stated shaper can be fed
/// radially; a tip radius that is not stated counts as none. Requires stated teeth.
std::int64_t least_fed_ring(const Cutters& cutters);

/// Judges whether the ring has at least that many teeth.
ConstraintReport shaper_feed(const Problem& problem, std::string_view mesh, std::int64_t ring);

// Of a design without profile shift.
ConstraintReport root_form_of_gears(const Problem& problem, const Rational& module_mm,
                                    std::string_view mesh, std::int64_t teeth_1,
                                    std::int64_t teeth_2);
ConstraintReport root_form_of_planet(const Problem& problem, const Rational& module_mm,
                                     std::string_view mesh, std::int64_t ring);
ConstraintReport root_form_of_ring(const Problem& problem, const Rational& module_mm,
                                   std::string_view mesh, std::int64_t planet, std::int64_t ring);

}  // namespace torquewright::gearbox
