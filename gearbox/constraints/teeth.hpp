// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "gearbox/constraints/design_report.hpp"

namespace torquewright::gearbox {

// Constraints on single gears and on the rings' size: docs/gearbox_constraints.md.

/// Judges whether the reduction is within the target's window. `exists` is false where the output
/// stands still.
ConstraintReport ratio_window(const Problem& problem, const Rational& reduction, bool exists);

/// Judges z >= the problem's minimum for that gear, 1 where it gives none.
ConstraintReport minimum_teeth(const Problem& problem, const std::string& gear, std::int64_t teeth);

/// Judges whether the held ring's pitch circle fits the rotor's bore.
ConstraintReport rotor_bore(const Problem& problem, const Rational& module_mm, std::int64_t ring);

/// Judges P1 - P2 >= n.
ConstraintReport tooth_difference(std::int64_t planet_1, std::int64_t planet_2,
                                  std::int64_t planet_count);

/// Judges z >= 2 h/sin^2(alpha), h the depth to which the stated hob is straight, else 1.
ConstraintReport undercut(const Problem& problem, std::string_view gear, std::int64_t teeth);

/// Judges whether the sun's tip circle stays clear of planet 2: m ((P1 - P2)/2 - 2) > 0.
ConstraintReport sun_under_layer_2(const Rational& module_mm, std::int64_t planet_1,
                                   std::int64_t planet_2);

/// Judges the wall left behind the ring's root in the largest blank there is room for.
ConstraintReport ring_wall(const Problem& problem, const Rational& module_mm, std::string_view gear,
                           std::int64_t teeth);

/// Judges whether the ring's tip circle lies outside its base circle.
ConstraintReport ring_tip(const Rational& module_mm, std::string_view gear, std::int64_t teeth);

}  // namespace torquewright::gearbox
