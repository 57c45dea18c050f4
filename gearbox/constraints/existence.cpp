// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/existence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <string>

#include "gearbox/constraints/condition.hpp"
#include "gearbox/constraints/cut_ring.hpp"
#include "gearbox/constraints/meshing.hpp"
#include "gearbox/constraints/root_form.hpp"
#include "gearbox/constraints/shifted_gears.hpp"
#include "gearbox/constraints/spacing.hpp"
#include "gearbox/constraints/teeth.hpp"
#include "gearbox/teeth/shaper.hpp"
#include "gearbox/teeth/shifted_mesh.hpp"
#include "gearbox/teeth/tooth_form.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"
#include "gearbox/train/cut_train.hpp"
#include "gearbox/train_parts.hpp"

namespace torquewright::gearbox {
namespace {

/// One module and no shift: lengths are fractions of the decimals that were written.
bool is_plain(const GearTrain& train) {
  return !train.layer_2_module_mm &&
         std::all_of(train.shifts.begin(), train.shifts.end(), [](double x) { return x == 0.0; });
}

Rational module_of(const CutGear& gear) { return io::exact(gear.module_mm); }

/// 2 a sin(pi/n) - d_a > 0; exact where no shift makes the centre distance irrational.
ConstraintReport neighbours(const CutTrain& cut, const CutGear& planet) {
  const std::string layer = planet.layer == 0 ? "layer_1" : "layer_2";
  const GearTrain& train = cut.train;
  if (is_plain(cut.train)) {
    const PlanetCircle circle{train.teeth[0], train.teeth[1], train.planet_count,
                              io::exact(train.module_mm)};
    return neighbour_clearance(circle, layer, planet.teeth, 0);
  }
  return neighbour_clearance(planet, cut.centre_mm, train.planet_count, 0);
}

/// s_a = d_a ((pi/2 + 2 x tan(alpha))/z + inv(alpha) - inv(alpha_a)) > 0. A ring's space has the
/// form of that tooth, so its tooth is the rest of the pitch.
ConstraintReport tip_thickness(const CutGear& gear) {
  DesignCondition condition{fmt::format("tip_thickness.{}", gear.name), "", "mm", Sense::kMoreThan};
  const auto angle = pressure_angle_rad(gear.count(), gear.tip_diameter);
  if (!angle) {
    return violated_without_value(condition,
                                  "does not exist, its tip lies inside its base circle.");
  }
  const double shape_rad =
      (std::numbers::pi / 2.0 + 2.0 * gear.shift * kReferenceTangent) / gear.count() +
      kReferenceInvolute - involute(*angle);
  const double tooth_rad = gear.internal ? std::numbers::pi / gear.count() - shape_rad : shape_rad;
  condition.value = module_of(gear) * fraction_of(gear.tip_diameter * tooth_rad);
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
void add_root_forms(const CutTrain& cut, const CutMesh& mesh, std::vector<ConstraintReport>& list) {
  const Cutters& cutters = cut.train.cutters;
  const PlanetInRing place = planet_in_ring(cut, mesh);
  const CutGear& planet = cut.gears[mesh.gear_1];
  if (const auto largest = largest_hob_tip_radius(place)) {
    list.push_back(judge(
        hob_condition(mesh.name, module_of(planet), *largest, as_written(cutters.hob_tip_radius))));
  }
  const auto shaper = shaper_of(cut, mesh);
  if (!shaper) return;
  const auto largest = largest_shaper_tip_radius(*shaper, place, planet.tip_diameter / 2.0);
  if (!largest) return;
  list.push_back(judge(shaper_condition(mesh.name, module_of(cut.gears[mesh.gear_2]), *largest,
                                        as_written(cutters.shaper_tip_radius), shaper->teeth)));
}

/// The tips of planet and ring leave each other without touching.
ConstraintReport trochoid(const CutTrain& cut, const CutMesh& mesh) {
  if (is_plain(cut.train)) {
    return trochoid_interference(mesh.name, cut.gears[mesh.gear_1].teeth,
                                 cut.gears[mesh.gear_2].teeth);
  }
  return trochoid_interference(mesh);
}

}  // namespace

std::vector<ConstraintReport> existence_conditions(const GearTrain& train) {
  const std::optional<CutTrain> cut = cut_train(train);
  if (!cut) return {};
  const TrainParts& parts = train_parts(train.topology);
  std::vector<ConstraintReport> list;
  // Planets without a ring beside the sun stand at equal angles, alike or not.
  if (const auto ring = parts.ring_of_layer(0)) {
    list.push_back(equal_spacing(train.teeth[0], train.teeth[*ring], train.planet_count,
                                 *ring == parts.held_ring ? "held ring" : "output ring"));
  }
  const std::span rings = std::span(cut->meshes).subspan(1);
  for (std::size_t gear = 1; gear < parts.free_gears; ++gear) {
    list.push_back(neighbours(*cut, cut->gears[gear]));
  }
  list.push_back(tip_thickness(cut->gears.front()));
  if (!parts.ring_of_layer(0)) list.push_back(tip_thickness(cut->gears[1]));
  if (!is_plain(train) || train.cutters.hob_addendum) {
    list.push_back(
        external_root_form(*cut, cut->meshes.front(), train.cutters.hob_tip_radius.value_or(0.0)));
  }
  if (!is_plain(train)) {
    for (const CutMesh& mesh : cut->meshes) list.push_back(bottom_clearance(*cut, mesh));
  }
  for (const CutMesh& mesh : rings) {
    list.push_back(tip_thickness(cut->gears[mesh.gear_1]));
    list.push_back(tip_thickness(cut->gears[mesh.gear_2]));
    list.push_back(trochoid(*cut, mesh));
    add_root_forms(*cut, mesh, list);
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
