// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/loaded_mesh.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "gearbox/constraints/existence.hpp"
#include "gearbox/constraints/gear_cutters.hpp"
#include "gearbox/train/cut_train.hpp"
#include "gearbox/train/loads.hpp"

namespace torquewright::gearbox {
namespace {

constexpr double kFewestTeeth = 8.0;
/// How far a ring's shift may be from the one that meshes without backlash, in modules: what
/// backlash takes, and rounding of published shifts.
constexpr double kShiftTolerance = 0.1;

ThreeKTeeth<double> three_k_teeth(const GearTrain& train) {
  const std::vector<double> z(train.teeth.begin(), train.teeth.end());
  return {z[0], z[1], z[2], z[3], z[4]};
}

/// Puts forces on the meshes of a train as it is cut.
class MeshBuilder {
 public:
  MeshBuilder(const GearTrain& train, const CutTrain& cut) : train_(train), cut_(cut) {}

  /// One force for each mesh, in their order.
  LoadedTrain loaded(const std::vector<double>& forces_N) {
    for (std::size_t i = 0; i < cut_.meshes.size(); ++i) add(cut_.meshes[i], forces_N[i]);
    const std::vector<GearCutter> cutters = gear_cutters(cut_);
    for (LoadedMesh& mesh : built_.meshes) {
      for (const std::size_t which : {0U, 1U}) {
        for (const GearCutter& cutter : cutters) {
          if (cutter.gear != mesh.gears[which]) continue;
          mesh.cutter_tip_radius[which] = cutter.tip_radius;
          mesh.cutter_addendum[which] = cutter.addendum;
          if (cutter.shaper_teeth > 0) mesh.shaper_teeth = cutter.shaper_teeth;
        }
      }
    }
    return std::move(built_);
  }

 private:
  void object(std::string_view mesh, const char* why) {
    built_.objections.push_back(
        fmt::format("{} do not mesh for teeth {}: {}", mesh, fmt::join(train_.teeth, ","), why));
  }

  void add(const CutMesh& made, double force_N) {
    const CutGear& first = cut_.gears[made.gear_1];
    const CutGear& second = cut_.gears[made.gear_2];
    if (!made.cut || (made.closing_ring_shift &&
                      std::abs(second.shift - *made.closing_ring_shift) > kShiftTolerance)) {
      return object(made.name, "it does not fit the centre distance of sun and planet");
    }
    // Planet 1 turns between sun and ring.
    LoadedMesh mesh{
        made.name, {first.name, second.name}, {made.gear_1 == 1, made.gear_2 == 1}, *made.cut, 0,
        {},        first.module_mm,           train_.face_width_mm[first.layer],    force_N};
    const ShiftedPair& pair = mesh.cut.pair;
    if (pair.teeth_1 < kFewestTeeth || pair.teeth_2 < kFewestTeeth) {
      return object(made.name, "stresses are computed for eight teeth and more");
    }
    const auto path = contact_path(mesh.cut);
    if (!path || !(contact_ratio(*path) >= 1.0)) {
      return object(made.name, "the contact ratio would be below 1");
    }
    // From the base circles' tangent points to the pitch point, in base pitches.
    const double pitch = std::tan(mesh.cut.working_angle_rad) / (2.0 * std::numbers::pi);
    const bool is_internal = pair.kind == MeshKind::kInternal;
    if (path->approach > pair.teeth_1 * pitch ||
        (!is_internal && path->recess > pair.teeth_2 * pitch)) {
      return object(made.name, "contact would reach inside a base circle (undercut)");
    }
    mesh.contact_ratio = contact_ratio(*path);
    built_.meshes.push_back(mesh);
  }

  const GearTrain& train_;
  const CutTrain& cut_;
  LoadedTrain built_;
};

/// On the mean planet for 1 Nm at the sun, in the order of the train's meshes.
std::vector<double> forces_N(const GearTrain& train, const CutTrain& cut) {
  const double ratio = reduction(train);
  const double centre_m = cut.centre_mm * 1e-3;
  if (train.topology == "3k") {
    const ThreeKLoads loads = three_k_loads(ratio, ratio, train.planet_count,
                                            working_radii(three_k_teeth(train), centre_m));
    return {std::abs(loads.sun_force_N), std::abs(loads.fixed_ring_force_N),
            std::abs(loads.output_ring_force_N)};
  }
  const double sun = cut.gears[0].count();
  const double sun_m = centre_m * sun / (sun + cut.gears[1].count());
  const double force_N = planetary_loads(ratio, ratio, train.planet_count, sun_m).tooth_force_N;
  return {force_N, force_N};
}

LoadedTrain refused(std::string why) { return {{}, {std::move(why)}}; }

}  // namespace

std::size_t layer_count(std::string_view topology) { return topology == "3k" ? 2 : 1; }

double reduction(const GearTrain& train) {
  if (train.topology == "3k") return three_k_reduction(three_k_teeth(train));
  const std::vector<double> z(train.teeth.begin(), train.teeth.end());
  return planetary_reduction(PlanetaryTeeth<double>{z[0], z[1], z[2]});
}

LoadedTrain loaded_train(const GearTrain& train) {
  const std::optional<CutTrain> cut = cut_train(train);
  if (!cut) {
    return refused(
        fmt::format("sun and planet do not mesh for teeth {}: their profile shifts leave no "
                    "working angle",
                    fmt::join(train.teeth, ",")));
  }
  if (!std::isfinite(reduction(train))) {
    return refused(fmt::format("the teeth {} have no ratio: the output ring stands still",
                               fmt::join(train.teeth, ",")));
  }
  return MeshBuilder(train, *cut).loaded(forces_N(train, *cut));
}

std::vector<std::string> objections(const GearTrain& train) {
  std::vector<std::string> list = loaded_train(train).objections;
  for (const ConstraintReport& violated : what_cannot_exist(train)) {
    list.push_back(violated.sentence);
  }
  return list;
}

}  // namespace torquewright::gearbox
