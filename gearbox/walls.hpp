// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "gearbox/problem.hpp"

namespace torquewright::gearbox {

/// Thickness of a ring's wall from its root circle outwards, in mm: as the problem states it, or
/// one tooth height (docs/decisions/0004).
Rational ring_wall_mm(const Problem& problem, const Rational& module_mm);

/// Outer diameter of a ring: root circle and two walls.
Rational ring_blank_mm(const Problem& problem, const Rational& module_mm, const Rational& teeth);

/// What is left between the sun's root circle and the hollow shaft [mm]; by default a rim as thick
/// as a ring's wall, which is what the mass counts.
Rational hollow_shaft_wall_mm(const Problem& problem, const Rational& module_mm);

/// Diameter that the rings' blanks have to fit into: the stated one, or the rotor's bore.
Rational ring_space_mm(const Problem& problem);
/// JSON pointer of that diameter.
std::string ring_space_key(const Problem& problem);

}  // namespace torquewright::gearbox
