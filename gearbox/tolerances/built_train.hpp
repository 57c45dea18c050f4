// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "gearbox/constraints/design_report.hpp"
#include "gearbox/tolerances/part_limits.hpp"

namespace torquewright::gearbox {

/// A train with the tolerances of its parts.
struct ToleratedTrain {
  CutTrain cut;
  std::vector<PartLimit> limits;
  /// Angle of the output for a length of backlash in each mesh, along its line of action [rad/mm].
  std::vector<double> output_rad_per_mm;

  double backlash_rad(std::span<const double> mesh_backlash_mm) const;
};

/// Of a design by its report. Throws std::invalid_argument, a sentence, where the gears have no
/// working angle at every centre distance within the limits.
ToleratedTrain tolerated_train(CutTrain cut, const DesignReport& report,
                               std::vector<PartLimit> limits);

// With Z = z1 + z2, X = x1 + x2, or in a ring Z = z2 - z1, X = x2 - x1, deviations ds of the
// teeth's thickness, tangents t of the profile angle at the tips, and + outside, - in a ring:
//
//   j = cos(alpha) (+-m (Z (inv(alpha_w) - inv(alpha)) - 2 tan(alpha) X) - ds1 - ds2)           (1)
//   dj/da = +-2 sin(alpha_w),  cos(alpha_w) = m Z cos(alpha)/(2 a)                              (2)
//   contact ratio = (z1 t1 +- z2 t2 -+ Z tan(alpha_w))/(2 pi)                                   (3)
//   clearance = a - r1 - r2, in a ring r2 - a - r1, of a tip and its mate's root                (4)
//
// (1) is what a pitch of the base circle has left beside both teeth, or a ring's space beside the
// planet's tooth; roots go with the shift, not with the thickness.

/// One mesh as it was made.
struct BuiltMesh {
  double backlash_mm = 0.0;  ///< Along the line of action; negative: the gears do not go together.
  double contact_ratio = 0.0;
  double tip_1_clearance_mm = 0.0;  ///< From the first gear's tip to its mate's root.
  double tip_2_clearance_mm = 0.0;

  double tip_clearance_mm() const { return std::min(tip_1_clearance_mm, tip_2_clearance_mm); }
};

/// How far each dimension of a train is from nominal, in the order of its limits: of one planet.
using Deviations = std::span<const double>;

/// A mesh of one planet.
BuiltMesh built_mesh(const ToleratedTrain& train, std::size_t mesh, Deviations deviations);

/// The backlash of a mesh for a change of the centre distance, per length: 2 sin(alpha_w), in a
/// ring its negative, eq. (2).
double backlash_per_centre_distance(const ToleratedTrain& train, std::size_t mesh,
                                    double centre_deviation_mm);

}  // namespace torquewright::gearbox
