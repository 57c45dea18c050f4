// SPDX-License-Identifier: Apache-2.0
#include "gearbox/tolerances/built_train.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "gearbox/teeth/profile_shift.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"

namespace torquewright::gearbox {
namespace {

/// A gear as it was made; lengths in mm.
struct BuiltGear {
  double teeth = 0.0;
  double module_mm = 0.0;
  double thickness_mm = 0.0;  ///< Beside the nominal one of its shift.
  double shift = 0.0;         ///< In modules.
  double tip_diameter_mm = 0.0;
  double root_diameter_mm = 0.0;

  double base_diameter_mm() const { return module_mm * teeth * kReferenceCosine; }
  /// Tangent of the profile angle at its tip, 0 inside its base circle.
  double tip_tangent() const {
    return std::sqrt(std::max(0.0, square(tip_diameter_mm / base_diameter_mm()) - 1.0));
  }
};

double centre_deviation_mm(const ToleratedTrain& train, Deviations deviations) {
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    if (train.limits[i].dimension == Dimension::kCentreDistance) return deviations[i];
  }
  return 0.0;
}

BuiltGear built_gear(const ToleratedTrain& train, std::size_t gear, Deviations deviations) {
  const CutGear& cut = train.cut.gears[gear];
  BuiltGear built{cut.count(), cut.module_mm, 0.0, cut.shift, cut.module_mm * cut.tip_diameter,
                  0.0};
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    const PartLimit& limit = train.limits[i];
    if (limit.gear != gear || limit.dimension == Dimension::kCentreDistance) continue;
    if (limit.dimension == Dimension::kToothThickness) built.thickness_mm += deviations[i];
    if (limit.dimension == Dimension::kProfileShift) built.shift += deviations[i];
    if (limit.dimension == Dimension::kTipDiameter) built.tip_diameter_mm += deviations[i];
  }
  built.root_diameter_mm =
      cut.module_mm * cut.root_diameter() + 2.0 * cut.module_mm * (built.shift - cut.shift);
  return built;
}

/// Two gears as made, at their centre distance; the sign is -1 in a ring.
struct BuiltPair {
  BuiltGear gear_1;
  BuiltGear gear_2;
  double sign = 1.0;
  double centre_mm = 0.0;
  double working_rad = 0.0;

  /// z1 + z2, in a ring z1 - z2.
  double teeth() const { return gear_1.teeth + sign * gear_2.teeth; }
};

// Eq. (1).
double backlash_mm(const BuiltPair& pair) {
  const double opened = std::abs(pair.teeth()) * (involute(pair.working_rad) - kReferenceInvolute);
  const double shifts =
      2.0 * kReferenceTangent * (pair.gear_1.shift + pair.sign * pair.gear_2.shift);
  const double along = pair.gear_1.module_mm * (pair.sign * opened - shifts);
  return kReferenceCosine * (along - pair.gear_1.thickness_mm - pair.gear_2.thickness_mm);
}

// Eq. (3).
double contact_ratio(const BuiltPair& pair) {
  return (pair.gear_1.teeth * pair.gear_1.tip_tangent() +
          pair.sign * pair.gear_2.teeth * pair.gear_2.tip_tangent() -
          pair.teeth() * std::tan(pair.working_rad)) /
         (2.0 * std::numbers::pi);
}

// Eq. (4): a - r_1 - r_2, in a ring r_2 - a - r_1.
double gap_mm(const BuiltPair& pair, double diameter_1_mm, double diameter_2_mm) {
  return pair.sign * (pair.centre_mm - 0.5 * diameter_2_mm) - 0.5 * diameter_1_mm;
}

std::optional<double> working_rad(const ToleratedTrain& train, const CutMesh& mesh,
                                  double centre_mm) {
  const CutGear &first = train.cut.gears[mesh.gear_1], &second = train.cut.gears[mesh.gear_2];
  const double teeth =
      second.internal ? second.count() - first.count() : first.count() + second.count();
  return working_angle_at_rad(teeth, centre_mm / first.module_mm);
}

BuiltPair built_pair(const ToleratedTrain& train, std::size_t mesh, Deviations deviations) {
  const CutMesh& gears = train.cut.meshes[mesh];
  BuiltPair pair;
  pair.gear_1 = built_gear(train, gears.gear_1, deviations);
  pair.gear_2 = built_gear(train, gears.gear_2, deviations);
  pair.sign = train.cut.gears[gears.gear_2].internal ? -1.0 : 1.0;
  pair.centre_mm = train.cut.centre_mm + centre_deviation_mm(train, deviations);
  pair.working_rad = working_rad(train, gears, pair.centre_mm).value();
  return pair;
}

void require_working_angles(const ToleratedTrain& train) {
  for (const PartLimit& limit : train.limits) {
    if (limit.dimension != Dimension::kCentreDistance) continue;
    const double least_mm = train.cut.centre_mm + limit.least;
    for (const CutMesh& mesh : train.cut.meshes) {
      if (working_rad(train, mesh, least_mm)) continue;
      throw std::invalid_argument(
          fmt::format("at a centre distance of {:g} mm {} has no working angle: the base circles "
                      "of its gears do not allow it",
                      least_mm, mesh.name));
    }
  }
}

}  // namespace

double ToleratedTrain::backlash_rad(std::span<const double> mesh_backlash_mm) const {
  return std::inner_product(output_rad_per_mm.begin(), output_rad_per_mm.end(),
                            mesh_backlash_mm.begin(), 0.0);
}

ToleratedTrain tolerated_train(CutTrain cut, const DesignReport& report,
                               std::vector<PartLimit> limits) {
  ToleratedTrain train{std::move(cut), std::move(limits), {}};
  for (const MeshReport& mesh : report.meshes) {
    train.output_rad_per_mm.push_back(mesh.backlash_share * report.output_backlash_rad_per_mm);
  }
  require_working_angles(train);
  return train;
}

BuiltMesh built_mesh(const ToleratedTrain& train, std::size_t mesh, Deviations deviations) {
  const BuiltPair pair = built_pair(train, mesh, deviations);
  return {backlash_mm(pair), contact_ratio(pair),
          gap_mm(pair, pair.gear_1.tip_diameter_mm, pair.gear_2.root_diameter_mm),
          gap_mm(pair, pair.gear_1.root_diameter_mm, pair.gear_2.tip_diameter_mm)};
}

double backlash_per_centre_distance(const ToleratedTrain& train, std::size_t mesh,
                                    double centre_deviation_mm) {
  const CutMesh& gears = train.cut.meshes[mesh];
  const double sign = train.cut.gears[gears.gear_2].internal ? -1.0 : 1.0;
  const auto angle_rad = working_rad(train, gears, train.cut.centre_mm + centre_deviation_mm);
  return 2.0 * sign * std::sin(angle_rad.value());
}

}  // namespace torquewright::gearbox
