// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "gearbox/teeth/tooth_form.hpp"
#include "gearbox/teeth/tooth_outline.hpp"

namespace torquewright::gearbox {

/// A gear in the plane; phase as in AssemblyPhase. Lengths in modules.
struct PlacedGear {
  ToothForm form;
  Point center;
  double phase_rad = 0.0;
};

/// How deep two gears reach into each other, at the worst point on either side of their teeth
/// [modules]. Positive: penetration. Negative: a gap.
struct Contact {
  double left = -1e300;
  double right = -1e300;

  double deepest() const { return std::max(left, right); }
  double loosest() const { return std::min(left, right); }
};

/// Points of both outlines no farther apart than a chord error of 1e-7 module allows, each measured
/// against the other gear. Knows nothing of phases or of lines of centres: on a flank by the
/// definition of the involute (unwound string), below it by the sampled root of the other gear.
Contact measure_contact(const PlacedGear& first, const PlacedGear& second);

/// The same for points of any origin against one gear.
Contact measure_points(const std::vector<Point>& points, const PlacedGear& gear);

}  // namespace torquewright::gearbox
