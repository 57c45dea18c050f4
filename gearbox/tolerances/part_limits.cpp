// SPDX-License-Identifier: Apache-2.0
#include "gearbox/tolerances/part_limits.hpp"

#include <cmath>

#include "gearbox/teeth/tooth_geometry.hpp"

namespace torquewright::gearbox {
namespace {

constexpr double kIt7 = 16.0, kIt8 = 25.0, kIt9 = 40.0;

bool is_planet(const CutTrain& train, std::size_t gear) {
  return gear > 0 && !train.gears[gear].internal;
}

PartLimit limit_of(const CutTrain& train, Dimension dimension, std::size_t gear, double least,
                   double greatest) {
  const char* word = dimension == Dimension::kToothThickness ? "tooth_thickness."
                     : dimension == Dimension::kProfileShift ? "profile_shift."
                                                             : "tip_diameter.";
  return {.dimension = dimension,
          .gear = gear,
          .name = word + std::string(train.gears[gear].name),
          .least = least,
          .greatest = greatest,
          .is_of_each_planet = is_planet(train, gear)};
}

void add_limits_of(const CutTrain& train, std::size_t gear, std::vector<PartLimit>& limits) {
  const CutGear& cut = train.gears[gear];
  const double thinner_mm =
      recommended_backlash_mm(train.centre_mm, cut.module_mm) / (2.0 * kReferenceCosine);
  const double reference_mm = cut.module_mm * cut.count();
  const double tolerance_mm = 2.0 * kReferenceTangent * kIt9 * tolerance_unit_mm(reference_mm);
  const double tip_mm = kIt8 * tolerance_unit_mm(cut.module_mm * cut.tip_diameter);
  limits.push_back(
      limit_of(train, Dimension::kToothThickness, gear, -thinner_mm - tolerance_mm, -thinner_mm));
  limits.push_back(limit_of(train, Dimension::kProfileShift, gear, 0.0, 0.0));
  limits.push_back(limit_of(train, Dimension::kTipDiameter, gear, cut.internal ? 0.0 : -tip_mm,
                            cut.internal ? tip_mm : 0.0));
}

}  // namespace

std::string unit_of(Dimension dimension) {
  return dimension == Dimension::kProfileShift ? "module" : "mm";
}

double tolerance_unit_mm(double length_mm) {
  return 1e-3 * (0.45 * std::cbrt(length_mm) + 0.001 * length_mm);
}

double recommended_backlash_mm(double centre_mm, double module_mm) {
  return 2.0 / 3.0 * (0.06 + 0.0005 * centre_mm + 0.03 * module_mm);
}

std::vector<PartLimit> usual_limits(const CutTrain& train) {
  const double half_mm = 0.5 * kIt7 * tolerance_unit_mm(train.centre_mm);
  std::vector<PartLimit> limits{{.dimension = Dimension::kCentreDistance,
                                 .name = "centre_distance",
                                 .least = -half_mm,
                                 .greatest = half_mm,
                                 .is_of_each_planet = true}};
  for (std::size_t gear = 0; gear < train.gears.size(); ++gear) {
    add_limits_of(train, gear, limits);
  }
  return limits;
}

}  // namespace torquewright::gearbox
