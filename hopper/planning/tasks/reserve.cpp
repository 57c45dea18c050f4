// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/tasks/reserve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/faults/refusal.hpp"

namespace torquewright::hopper {

// The proportions are those of margins chosen by hand with which the hopper's flip stands in 96 of
// 100 replays: 8 % of voltage, 15 % of friction, 30 % of the foot, 0.15 rad. The capture point
// keeps to the part of the foot that the pressure point, which is to stop it, keeps to. Over edges
// 0.12 keeps the 3 cm that other bodies keep from the ground.
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
      {"edges of the ground", "--edge-margin", "m",
       "How far the sole keeps above the edges of the ground that a flight passes, in m",
       &Margins::edge_m, 0.25, 0.3},
      {"joint speed", "--speed-margin", "", "Share of the joints' speed limits that is kept",
       &Margins::speed, 0.0, 0.9},
      {"gears", "--gear-margin", "", "Share of each transmission's limit that is kept",
       &Margins::gear_load, 0.0, 0.9},
  };
  return parts;
}

namespace {

/// The reserve at which a part takes all that it may.
double most_reserve(const MarginPart& part) { return part.most / part.per_reserve; }

/// Of the parts that the reserve has, the one that takes all there is first.
const MarginPart& tightest() {
  const auto before = [](const MarginPart& one, const MarginPart& other) {
    return other.per_reserve == 0.0 ||
           (one.per_reserve > 0.0 && most_reserve(one) < most_reserve(other));
  };
  return *std::min_element(margin_parts().begin(), margin_parts().end(), before);
}

}  // namespace

bool is_kept(const MarginPart& part, const PlanOptions& options) {
  if (part.margin != &PlanMargins::edge_m) return true;
  return std::any_of(options.landings_m.begin(), options.landings_m.end(),
                     [](double height_m) { return height_m != 0.0; });
}

double greatest_reserve() { return most_reserve(tightest()); }

PlanMargins with_reserve(double reserve) {
  const MarginPart& least = tightest();
  if (reserve > most_reserve(least)) {
    io::refuse("--reserve",
               fmt::format("{:g} would keep {:g}{}{} of {} ({}), and {:g} is the most that leaves "
                           "something to plan with: --reserve {:g}",
                           reserve, least.per_reserve * reserve, least.unit.empty() ? "" : " ",
                           least.unit, least.name, least.option, least.most,
                           std::floor(1e3 * most_reserve(least)) / 1e3));
  }
  PlanMargins margins;
  for (const MarginPart& part : margin_parts()) {
    double& margin = margins.*part.margin;
    margin = std::max(margin, part.per_reserve * reserve);
  }
  return margins;
}

}  // namespace torquewright::hopper
