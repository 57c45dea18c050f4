// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "gearbox/constraints/design_report.hpp"
#include "gearbox/teeth/mesh.hpp"
#include "gearbox/teeth/profile_shift.hpp"

namespace torquewright::gearbox {

// Constraints on two gears in mesh without profile shift: docs/gearbox_constraints.md.

/// Judges the involute interference of a planet in a ring. Where the ring's tip lies inside its
/// base circle the value does not exist.
ConstraintReport involute_interference(std::string_view mesh, std::int64_t planet,
                                       std::int64_t ring);
ConstraintReport trochoid_interference(std::string_view mesh, std::int64_t planet,
                                       std::int64_t ring);

/// Returns the ends of the path of contact; zeros where the mesh does not exist (a planet that does
/// not fit in its ring, a ring whose tip lies inside its base circle).
ContactPath<double> external_path_of(std::int64_t teeth_1, std::int64_t teeth_2);
ContactPath<double> internal_path_of(std::int64_t planet, std::int64_t ring);

/// Judges epsilon >= the problem's minimum.
ConstraintReport contact_ratio_limit(const Problem& problem, std::string_view mesh, MeshKind kind,
                                     const ContactPath<double>& path);

/// Judges a held ring or output ring that is not the one of equations (2), (3), with the shift that
/// would close it. `teeth_between_centres` is S + P1, which sets the centre distance.
ConstraintReport coaxiality(std::string_view ring_name, std::int64_t planet, std::int64_t ring,
                            std::int64_t teeth_between_centres);

}  // namespace torquewright::gearbox
