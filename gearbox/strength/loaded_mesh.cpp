// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/loaded_mesh.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "gearbox/constraints/existence.hpp"
#include "gearbox/constraints/gear_cutters.hpp"
#include "gearbox/topologies/topology.hpp"
#include "gearbox/train/cut_train.hpp"

namespace torquewright::gearbox {
namespace {

constexpr double kFewestTeeth = 8.0;
/// How far a ring's shift may be from the one that meshes without backlash, in modules: what
/// backlash takes, and rounding of published shifts.
constexpr double kShiftTolerance = 0.1;

std::vector<double> real_teeth(const GearTrain& train) {
  return {train.teeth.begin(), train.teeth.end()};
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
  /// A planet that turns between sun and held ring: the two push it alike, on either side of it. An
  /// output ring is pushed by the flank that the sun pushes.
  bool bends_both_ways(std::size_t gear) const {
    const TrainParts& parts = train_parts(train_.topology);
    return gear == 1 && parts.gear_layers[parts.held_ring] == 0;
  }

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
    LoadedMesh mesh{made.name,
                    {first.name, second.name},
                    {bends_both_ways(made.gear_1), bends_both_ways(made.gear_2)},
                    *made.cut,
                    0,
                    {},
                    first.module_mm,
                    train_.face_width_mm[first.layer],
                    force_N};
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

LoadedTrain refused(std::string why) { return {{}, {std::move(why)}}; }

}  // namespace

double reduction(const GearTrain& train) {
  return find_topology(train.topology)->reduction(real_teeth(train));
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
  return MeshBuilder(train, *cut)
      .loaded(find_topology(train.topology)
                  ->forces_N(real_teeth(train), train.planet_count, cut->centre_mm * 1e-3));
}

std::vector<std::string> objections(const GearTrain& train) {
  std::vector<std::string> list = loaded_train(train).objections;
  for (const ConstraintReport& violated : what_cannot_exist(train)) {
    list.push_back(violated.sentence);
  }
  return list;
}

}  // namespace torquewright::gearbox
