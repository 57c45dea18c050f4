// SPDX-License-Identifier: Apache-2.0
#include "gearbox/teeth/shifted_mesh.hpp"

#include <cmath>
#include <numbers>

#include "gearbox/teeth/tooth_geometry.hpp"

namespace torquewright::gearbox {

namespace {

struct TipAngles {
  double gear_1_rad;
  double gear_2_rad;
};

std::optional<TipAngles> tip_angles(const CutPair& cut) {
  const auto first = pressure_angle_rad(cut.pair.teeth_1, cut.tip_diameter_1);
  const auto second = pressure_angle_rad(cut.pair.teeth_2, cut.tip_diameter_2);
  if (!first || !second) return std::nullopt;
  return TipAngles{*first, *second};
}

std::optional<double> arc_cosine(double value) {
  if (!(std::abs(value) <= 1.0)) return std::nullopt;
  return std::acos(value);
}

std::optional<double> arc_sine_of_root(double value) {
  if (!(value >= 0.0 && value <= 1.0)) return std::nullopt;
  return std::asin(std::sqrt(value));
}

}  // namespace

std::optional<double> pressure_angle_rad(double teeth, double diameter) {
  if (!(diameter > 0.0)) return std::nullopt;
  return arc_cosine(teeth * kReferenceCosine / diameter);
}

std::optional<ContactPath<double>> contact_path(const CutPair& cut) {
  const std::optional<TipAngles> tip = tip_angles(cut);
  if (!tip) return std::nullopt;
  const double turn = 2.0 * std::numbers::pi;
  const double working = std::tan(cut.working_angle_rad);
  const double sign = cut.pair.kind == MeshKind::kExternal ? 1.0 : -1.0;
  return ContactPath<double>{sign * cut.pair.teeth_2 * (std::tan(tip->gear_2_rad) - working) / turn,
                             cut.pair.teeth_1 * (std::tan(tip->gear_1_rad) - working) / turn};
}

std::optional<double> involute_interference_margin(const CutPair& cut) {
  const std::optional<TipAngles> tip = tip_angles(cut);
  if (!tip) return std::nullopt;
  return cut.pair.teeth_1 / cut.pair.teeth_2 - 1.0 +
         std::tan(tip->gear_2_rad) / std::tan(cut.working_angle_rad);
}

std::optional<double> trochoid_interference_margin(const CutPair& cut) {
  const std::optional<TipAngles> tip = tip_angles(cut);
  if (!tip) return std::nullopt;
  const double radius_1 = cut.tip_diameter_1 / 2.0;
  const double radius_2 = cut.tip_diameter_2 / 2.0;
  const double centre = centre_distance(cut.pair, cut.working_angle_rad);
  const auto at_planet =
      arc_cosine((square(radius_2) - square(radius_1) - square(centre)) / (2 * centre * radius_1));
  const auto at_ring =
      arc_cosine((square(centre) + square(radius_2) - square(radius_1)) / (2 * centre * radius_2));
  if (!at_planet || !at_ring) return std::nullopt;
  const double working = involute(cut.working_angle_rad);
  return (*at_planet + involute(tip->gear_1_rad) - working) * cut.pair.teeth_1 / cut.pair.teeth_2 +
         working - involute(tip->gear_2_rad) - *at_ring;
}

std::optional<double> trimming_margin(const CutPair& cut) {
  const std::optional<TipAngles> tip = tip_angles(cut);
  if (!tip) return std::nullopt;
  const double cosines = std::cos(tip->gear_1_rad) / std::cos(tip->gear_2_rad);
  const double teeth = cut.pair.teeth_1 / cut.pair.teeth_2;
  const auto at_planet = arc_sine_of_root((1.0 - square(cosines)) / (1.0 - square(teeth)));
  const auto at_ring =
      arc_sine_of_root((1.0 / square(cosines) - 1.0) / (1.0 / square(teeth) - 1.0));
  if (!at_planet || !at_ring) return std::nullopt;
  const double working = involute(cut.working_angle_rad);
  return *at_planet + involute(tip->gear_1_rad) - working -
         (*at_ring + involute(tip->gear_2_rad) - working) / teeth;
}

}  // namespace torquewright::gearbox
