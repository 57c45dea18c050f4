// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <vector>

#include "src/report/workshop/gear_bodies.hpp"

namespace torquewright::test {

inline const report::BodySizes kCompoundSizes{{10.0, 9.0}, {4.0, 0.0, 5.0, 0.0, 0.0}};

/// A 3K train of few teeth, in which the sun is undercut.
inline report::DrawnGearbox compound() {
  return {.name = "small",
          .topology = "3k",
          .teeth = {15, 24, 21, 63, 60},
          .planet_count = 3,
          .module_mm = 0.6,
          .ratio = "64",
          .hollow_shaft_diameter_mm = 4.0,
          .ring_wall_mm = {}};
}

/// A single stage of module 1.
inline report::DrawnGearbox stage() {
  return {.name = "d'\xC3\xA9tage",
          .topology = "planetary",
          .teeth = {15, 30, 75},
          .planet_count = 3,
          .module_mm = 1.0,
          .ratio = "6",
          .ring_wall_mm = 3.0};
}

/// Area inside a polygon by its corners [mm^2]: the shoelace formula.
inline double shoelace_mm2(const std::vector<gearbox::Point>& corners) {
  double twice_mm2 = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const gearbox::Point& from = corners[i];
    const gearbox::Point& to = corners[(i + 1) % corners.size()];
    twice_mm2 += from.x * to.y - to.x * from.y;
  }
  return 0.5 * twice_mm2;
}

/// Area inside a gear's exact outline: its points no farther apart than chords of 1e-7 modules
/// allow, one pitch times the teeth.
inline double exact_area_mm2(const report::DrawnGear& gear) {
  std::vector<gearbox::Point> pitch = gearbox::sample(gearbox::pitch_curves(*gear.form), 1e-7);
  pitch.push_back({0.0, 0.0});
  return gear.module_mm * gear.module_mm * static_cast<double>(gear.teeth) * shoelace_mm2(pitch);
}

/// Volume of a gear's solid: its outline's area less the bore's, or a blank's less its outline's.
inline double exact_volume_mm3(const report::DrawnGear& gear, const report::GearBody& body) {
  const double circle_mm2 =
      0.25 * std::numbers::pi * body.circle_diameter_mm * body.circle_diameter_mm;
  const double area_mm2 = exact_area_mm2(gear) - circle_mm2;
  return body.width_mm * (body.is_ring ? -area_mm2 : area_mm2);
}

}  // namespace torquewright::test
