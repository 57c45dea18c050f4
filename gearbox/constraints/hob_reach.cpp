// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/hob_reach.hpp"

#include <algorithm>
#include <cmath>

#include "gearbox/teeth/root_form.hpp"
#include "gearbox/teeth/tooth_form.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"

namespace torquewright::gearbox {
namespace {

/// From the base circle's tangent point of gear 1 to where the tip of gear 2 touches it, in
/// modules.
double lowest_contact(const CutPair& cut) {
  const ShiftedPair& pair = cut.pair;
  const double base_2 = pair.teeth_2 * kReferenceCosine / 2.0;
  const double reach = std::sqrt(std::max(0.0, square(cut.tip_diameter_2 / 2.0) - square(base_2)));
  return centre_distance(pair, cut.working_angle_rad) * std::sin(cut.working_angle_rad) - reach;
}

CutPair seen_from_the_mate(const CutPair& cut) {
  const ShiftedPair& pair = cut.pair;
  return {{pair.kind, pair.teeth_2, pair.teeth_1, pair.shift_2, pair.shift_1},
          cut.working_angle_rad,
          cut.tip_diameter_2,
          cut.tip_diameter_1};
}

/// docs/derivations/tooth_outline.md eq. (8), with the reach of an external mate.
double largest_hob_tip_radius_of_first(const CutPair& cut, double hob_addendum) {
  const double to_tangent_point = cut.pair.teeth_1 / 2.0 * kReferenceSine;
  const double straight_depth =
      cut.pair.shift_1 + kReferenceSine * (to_tangent_point - lowest_contact(cut));
  return largest_hob_tip_radius_for(hob_addendum, straight_depth);
}

}  // namespace

double undercut_depth(const Cutters& cutters) {
  const double addendum = cutters.hob_depth();
  if (cutters.hob_tip_radius) return straight_depth_of_hob(addendum, *cutters.hob_tip_radius);
  return std::max(1.0, straight_depth_of_hob(addendum, kHobTipRadius));
}

std::optional<std::array<double, 2>> largest_hob_tip_radii(const CutTrain& train,
                                                           const CutMesh& mesh) {
  const CutPair of_planet = seen_from_the_mate(*mesh.cut);
  if (lowest_contact(*mesh.cut) <= 0.0 || lowest_contact(of_planet) <= 0.0) return std::nullopt;
  const double addendum = train.train.cutters.hob_depth();
  return std::array{largest_hob_tip_radius_of_first(*mesh.cut, addendum),
                    largest_hob_tip_radius_of_first(of_planet, addendum)};
}

}  // namespace torquewright::gearbox
