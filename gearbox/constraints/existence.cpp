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
#include "gearbox/constraints/made_train.hpp"
#include "gearbox/constraints/meshing.hpp"
#include "gearbox/constraints/root_form.hpp"
#include "gearbox/constraints/spacing.hpp"
#include "gearbox/constraints/teeth.hpp"
#include "gearbox/teeth/shaper.hpp"
#include "gearbox/teeth/shifted_mesh.hpp"
#include "gearbox/teeth/tooth_form.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"

namespace torquewright::gearbox {
namespace {

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

std::optional<Rational> as_written(const std::optional<double>& value) {
  if (!value) return std::nullopt;
  return io::exact(*value);
}

/// Hob and shaper leave the involutes of planet and ring to where the mate's tip touches them.
/// Where the ring's tip touches none at all, interference.involute says so.
void add_root_forms(const MadeTrain& train, const MadeLayer& layer, const Cutters& cutters,
                    std::vector<ConstraintReport>& list) {
  const PlanetInRing mesh = planet_in_ring(train, layer);
  if (const auto largest = largest_hob_tip_radius(mesh)) {
    list.push_back(judge(hob_condition(layer.ring_mesh, train.module_mm, *largest,
                                       as_written(cutters.hob_tip_radius))));
  }
  const auto shaper = shaper_of(layer, cutters);
  if (!shaper) return;
  const auto largest = largest_shaper_tip_radius(*shaper, mesh, layer.planet.tip_diameter / 2.0);
  if (!largest) return;
  list.push_back(judge(shaper_condition(layer.ring_mesh, train.module_mm, *largest,
                                        as_written(cutters.shaper_tip_radius), shaper->teeth)));
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

GearTrain train_of(const Problem& problem, const Design& design) {
  return {problem.topology,
          design.teeth,
          std::vector(design.teeth.size(), 0.0),
          design.planet_count,
          io::nearest(design.module_mm),
          {},
          cutters_of(problem)};
}

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
    add_root_forms(*parts, layer, train.cutters, list);
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
