// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/existence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <string_view>

#include "gearbox/constraints/condition.hpp"
#include "gearbox/constraints/meshing.hpp"
#include "gearbox/constraints/spacing.hpp"
#include "gearbox/constraints/teeth.hpp"
#include "gearbox/teeth/shifted_mesh.hpp"
#include "gearbox/teeth/tooth_form.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"

namespace torquewright::gearbox {
namespace {

/// A gear of the train; lengths in modules.
struct MadeGear {
  std::string_view name;
  std::int64_t teeth = 0;
  double shift = 0.0;
  double tip_diameter = 0.0;

  double count() const { return static_cast<double>(teeth); }
};

struct MadeLayer {
  std::string_view name;
  std::string_view ring_mesh;
  MadeGear planet;
  MadeGear ring;
};

/// What the conditions below need of a train whose sun and planet 1 mesh.
struct MadeTrain {
  MadeGear sun;
  std::vector<MadeLayer> layers;
  std::int64_t planet_count = 0;
  Rational module_mm;
  double centre = 0.0;  ///< In modules.
  bool is_shifted = false;
};

std::optional<MadeTrain> made(const GearTrain& train) {
  const auto& z = train.teeth;
  const auto& x = train.shifts;
  const auto real = [&z](std::size_t gear) { return static_cast<double>(z[gear]); };
  const ShiftedPair first{MeshKind::kExternal, real(0), real(1), x[0], x[1]};
  const auto angle = working_angle_rad(first);
  if (!angle) return std::nullopt;
  MadeTrain result;
  result.planet_count = train.planet_count;
  result.module_mm = io::exact(train.module_mm);
  result.centre = centre_distance(first, *angle);
  result.is_shifted = std::any_of(x.begin(), x.end(), [](double shift) { return shift != 0.0; });
  const double increment = centre_increment(first, result.centre);
  result.sun = {"sun", z[0], x[0], tip_diameter_keeping_clearance(real(0), x[1], increment)};
  const double planet_1_tip = tip_diameter_planet_1(real(1), x[1], x[0], increment);
  const auto ring = [&](std::string_view name, std::size_t gear) {
    return MadeGear{name, z[gear], x[gear], tip_diameter_ring(real(gear), x[gear])};
  };
  if (train.topology == "3k") {
    const MadeGear planet_2{"planet_2", z[2], x[2], tip_diameter_external(real(2), x[2])};
    result.layers = {{"layer_1",
                      "planet_1_fixed_ring",
                      {"planet_1", z[1], x[1], planet_1_tip},
                      ring("fixed_ring", 3)},
                     {"layer_2", "planet_2_output_ring", planet_2, ring("output_ring", 4)}};
  } else {
    result.layers = {
        {"layer_1", "planet_ring", {"planet", z[1], x[1], planet_1_tip}, ring("ring", 2)}};
  }
  return result;
}

/// 2 a sin(pi/n) - d_a > 0; exact where no shift makes the centre distance irrational.
ConstraintReport neighbours(const MadeTrain& train, const MadeLayer& layer) {
  if (!train.is_shifted) {
    const PlanetCircle circle{train.sun.teeth, train.layers.front().planet.teeth,
                              train.planet_count, train.module_mm};
    return neighbour_clearance(circle, layer.name, layer.planet.teeth, 0);
  }
  DesignCondition condition{fmt::format("neighbour_clearance.{}", layer.name), "", "mm",
                            Sense::kMoreThan};
  const double chord =
      2.0 * train.centre * std::sin(std::numbers::pi / static_cast<double>(train.planet_count));
  condition.value = train.module_mm * fraction_of(chord - layer.planet.tip_diameter);
  condition.meaning = "between the tips of neighbouring planets";
  condition.remedy = "needs fewer planets, smaller ones or a longer centre distance";
  return judge(condition);
}

/// s_a = d_a ((pi/2 + 2 x tan(alpha))/z + inv(alpha) - inv(alpha_a)) > 0. A ring's space has the
/// form of that tooth, so its tooth is the rest of the pitch.
ConstraintReport tip_thickness(const MadeTrain& train, const MadeGear& gear, bool internal) {
  DesignCondition condition{fmt::format("tip_thickness.{}", gear.name), "", "mm", Sense::kMoreThan};
  const auto angle = pressure_angle_rad(gear.count(), gear.tip_diameter);
  if (!angle) {
    return violated_without_value(condition,
                                  "does not exist, its tip lies inside its base circle.");
  }
  const double shape_rad =
      (std::numbers::pi / 2.0 + 2.0 * gear.shift * kReferenceTangent) / gear.count() +
      kReferenceInvolute - involute(*angle);
  const double tooth_rad = internal ? std::numbers::pi / gear.count() - shape_rad : shape_rad;
  condition.value = train.module_mm * fraction_of(gear.tip_diameter * tooth_rad);
  condition.meaning = "of tooth at the tip circle";
  condition.remedy = "needs less profile shift";
  return judge(condition);
}

/// A hob leaves the planet's involute down to where the ring's tip touches it. Where the ring's tip
/// touches none at all, interference.involute says so.
std::optional<ConstraintReport> root_form(const MadeTrain& train, const MadeLayer& layer,
                                          const Cutters& cutters) {
  const auto largest =
      largest_hob_tip_radius({layer.planet.count(), layer.planet.shift, layer.ring.count(),
                              layer.ring.tip_diameter / 2.0, train.centre});
  if (!largest) return std::nullopt;
  DesignCondition condition{fmt::format("root_form.{}", layer.ring_mesh), "", "mm"};
  condition.value = train.module_mm * fraction_of(*largest);
  condition.limit = train.module_mm * io::exact(cutters.hob_tip_radius.value_or(0.0));
  condition.meaning =
      "of rounding at most on the tip of the hob that leaves the planet's flank "
      "down to where the ring's tip touches it";
  condition.remedy = "needs a sharper hob, or more teeth between planet and ring";
  return judge(condition);
}

/// The tips of planet and ring leave each other without touching.
ConstraintReport trochoid(const MadeTrain& train, const MadeLayer& layer) {
  if (!train.is_shifted) {
    return trochoid_interference(layer.ring_mesh, layer.planet.teeth, layer.ring.teeth);
  }
  DesignCondition condition{fmt::format("interference.trochoid.{}", layer.ring_mesh), "", "rad"};
  const ShiftedPair pair{MeshKind::kInternal, layer.planet.count(), layer.ring.count(),
                         layer.planet.shift, layer.ring.shift};
  const auto angle = working_angle_at_rad(teeth_between_centres(pair), train.centre);
  const auto margin = angle ? trochoid_interference_margin({pair, *angle, layer.planet.tip_diameter,
                                                            layer.ring.tip_diameter})
                            : std::nullopt;
  if (!margin) {
    return violated_without_value(condition, "does not exist: planet and ring do not mesh there.");
  }
  condition.value = fraction_of(*margin);
  condition.meaning = "between the tips of planet and ring where they leave each other";
  condition.remedy = "needs more teeth between planet and ring, or other profile shifts";
  return judge(condition);
}

}  // namespace

std::vector<ConstraintReport> existence_conditions(const GearTrain& train) {
  const std::optional<MadeTrain> parts = made(train);
  if (!parts) return {};
  const std::size_t held_ring = train.topology == "3k" ? 3 : 2;
  std::vector<ConstraintReport> list{
      equal_spacing(train.teeth[0], train.teeth[held_ring], train.planet_count)};
  for (const MadeLayer& layer : parts->layers) list.push_back(neighbours(*parts, layer));
  list.push_back(tip_thickness(*parts, parts->sun, false));
  for (const MadeLayer& layer : parts->layers) {
    list.push_back(tip_thickness(*parts, layer.planet, false));
    list.push_back(tip_thickness(*parts, layer.ring, true));
    list.push_back(trochoid(*parts, layer));
    if (auto form = root_form(*parts, layer, train.cutters)) list.push_back(std::move(*form));
  }
  return list;
}

std::vector<ConstraintReport> what_cannot_exist(const GearTrain& train) {
  const std::vector<ConstraintReport> all = existence_conditions(train);
  std::vector<ConstraintReport> violated;
  std::copy_if(all.begin(), all.end(), std::back_inserter(violated),
               [](const ConstraintReport& condition) { return !condition.satisfied; });
  return violated;
}

}  // namespace torquewright::gearbox
