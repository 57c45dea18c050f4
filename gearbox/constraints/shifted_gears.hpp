// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/constraints/design_report.hpp"
#include "gearbox/train/cut_train.hpp"

namespace torquewright::gearbox {

// The constraints of docs/gearbox_constraints.md that profile shift or a second module changes, on
// gears as they are cut. Without both they have the values of meshing.hpp, spacing.hpp, teeth.hpp.

/// Largest error of a ring's shift against the one that closes the centre distance, in modules:
/// what remains of shifts that are printed to three decimals.
inline constexpr double kCoaxialTolerance = 0.002;

/// Judges whether the ring meshes without backlash at the centre distance of sun and planet.
ConstraintReport coaxiality(const CutTrain& train, const CutMesh& mesh);

/// Judges 2 a sin(pi/n) - d_a > limit.
ConstraintReport neighbour_clearance(const CutGear& planet, double centre_mm,
                                     std::int64_t planet_count, const Rational& minimum_mm);

/// Judges z >= 2 (h - x)/sin^2(alpha), h as deep as the stated hob is straight, or 1.
ConstraintReport undercut(const Cutters& cutters, const CutGear& gear);

/// Judges a - r_aS - r_aP2 > 0.
ConstraintReport sun_under_layer_2(const CutTrain& train);

/// Judges whether planets without a ring stay inside the room that rings' blanks have: 2 a + d_a.
ConstraintReport planet_room(const Problem& problem, const CutGear& planet, double centre_mm);

ConstraintReport ring_wall(const Problem& problem, const CutGear& ring);
ConstraintReport ring_tip(const CutGear& ring);

/// Judges the involute interference of a planet in a ring.
ConstraintReport involute_interference(const CutMesh& mesh);
ConstraintReport trochoid_interference(const CutMesh& mesh);

/// Returns the path of contact; zeros where there is none.
ContactPath<double> contact_path_of(const CutMesh& mesh);
ConstraintReport contact_ratio_limit(const Problem& problem, const CutMesh& mesh);

/// Judges whether the narrower of the clearances from the tip of one gear to the root of its mate
/// is above 0.
ConstraintReport bottom_clearance(const CutTrain& train, const CutMesh& mesh);

/// Judges whether the stated shaper can be fed into the ring radially without cutting away its
/// tips. Requires stated teeth.
ConstraintReport shaper_feed(const CutTrain& train, const CutMesh& mesh);

/// Judges whether the hob leaves the involutes of both external gears down to where the mate's tip
/// touches them.
ConstraintReport external_root_form(const CutTrain& train, const CutMesh& mesh,
                                    double hob_tip_radius);

}  // namespace torquewright::gearbox
