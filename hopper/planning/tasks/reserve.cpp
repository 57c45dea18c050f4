// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/tasks/reserve.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/faults/refusal.hpp"

namespace torquewright::hopper {

// The proportions are those of margins chosen by hand with which the hopper's flip stands in 96 of
// 100 replays: 8 % of voltage, 15 % of friction, 30 % of the foot, 0.15 rad. The capture point
// keeps to the part of the foot that the pressure point, which is to stop it, keeps to.
const std::vector<MarginPart>& margin_parts() {
  using Margins = PlanMargins;
  static const std::vector<MarginPart> parts{
      {"voltage", "--voltage-margin", "",
       "Share of the bus voltage kept from a region's voltage bound", &Margins::voltage, 1.0, 0.9},
      {"current", "--current-margin", "", "Share of a region's current bound that is kept",
       &Margins::current, 0.0, 0.9},
      {"friction cone", "--friction-margin", "",
       "Share of the ground's friction coefficient that is kept", &Margins::friction, 1.875, 0.95},
      {"centre of pressure", "--center-of-pressure-margin", "",
       "Share of the foot's length kept from either end of it", &Margins::center_of_pressure, 3.75,
       0.49},
      {"capture point", "--capture-point-margin", "",
       "Share of the foot's length that the capture point keeps from either end of it where the "
       "last phase begins; 0: it may be anywhere",
       &Margins::capture_point, 3.75, 0.49},
      {"joint range", "--position-margin", "rad",
       "How far joints keep from the ends of their ranges, in rad", &Margins::position_rad, 1.875,
       1.0},
      {"joint range in flight", "--flight-position-margin", "rad",
       "How far they keep from them in flight, in rad, where that is more",
       &Margins::flight_position_rad, 1.875, 1.0},
      {"joint speed", "--speed-margin", "", "Share of the joints' speed limits that is kept",
       &Margins::speed, 0.0, 0.9},
      {"gears", "--gear-margin", "", "Share of each transmission's limit that is kept",
       &Margins::gear_load, 0.0, 0.9},
  };
  return parts;
}

PlanMargins with_reserve(double reserve) {
  PlanMargins margins;
  for (const MarginPart& part : margin_parts()) {
    const double asked = part.per_reserve * reserve;
    if (asked > part.most) {
      io::refuse(
          "--reserve",
          fmt::format("{:g} would keep {:g}{}{} of {} ({}), and {:g} is the most that leaves "
                      "something to plan with: --reserve {:.3g}",
                      reserve, asked, part.unit.empty() ? "" : " ", part.unit, part.name,
                      part.option, part.most, part.most / part.per_reserve));
    }
    double& margin = margins.*part.margin;
    margin = std::max(margin, asked);
  }
  return margins;
}

}  // namespace torquewright::hopper
