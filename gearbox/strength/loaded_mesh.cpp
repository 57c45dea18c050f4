// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/loaded_mesh.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "gearbox/constraints/existence.hpp"
#include "gearbox/constraints/gear_cutters.hpp"
#include "gearbox/train/loads.hpp"

namespace torquewright::gearbox {
namespace {

constexpr double kFewestTeeth = 8.0;
/// How far a ring's shift may be from the one that meshes without backlash, in modules: what
/// backlash takes, and rounding of published shifts.
constexpr double kShiftTolerance = 0.1;

std::vector<double> real_teeth(const GearTrain& train) {
  return {train.teeth.begin(), train.teeth.end()};
}

ThreeKTeeth<double> three_k_teeth(const GearTrain& train) {
  const std::vector<double> z = real_teeth(train);
  return {z[0], z[1], z[2], z[3], z[4]};
}

/// Builds the meshes at the centre distance of sun and first planet.
class MeshBuilder {
 public:
  explicit MeshBuilder(const GearTrain& train) : train_(train), z_(real_teeth(train)) {
    const ShiftedPair first = external_pair();
    if (const auto angle = working_angle_rad(first)) {
      sun_angle_rad_ = *angle;
      centre_ = centre_distance(first, *angle);
      increment_ = centre_increment(first, centre_);
    } else {
      object("sun and planet", "their profile shifts leave no working angle");
    }
  }

  bool can_mesh() const { return train_built_.objections.empty(); }

  void add_sun_mesh(std::string_view name, std::string_view planet, double force_N) {
    const auto& x = train_.shifts;
    LoadedMesh mesh{name, {"sun", planet},         {false, true}, {}, 0,
                    {},   train_.face_width_mm[0], force_N};
    mesh.cut = {external_pair(), sun_angle_rad_,
                tip_diameter_keeping_clearance(z_[0], x[1], increment_),
                tip_diameter_planet_1(z_[1], x[1], x[0], increment_)};
    add(mesh);
  }

  /// A planet in a ring by their places in the topology's order.
  void add_ring_mesh(std::string_view name, std::size_t planet, std::string_view planet_name,
                     std::size_t ring, std::string_view ring_name, double force_N) {
    const auto& x = train_.shifts;
    const bool is_first = planet == 1;
    const ShiftedPair pair{MeshKind::kInternal, z_[planet], z_[ring], x[planet], x[ring]};
    const auto closing = closing_shift(pair, centre_);
    const auto angle = working_angle_at_rad(teeth_between_centres(pair), centre_);
    if (!closing || !angle || std::abs(x[ring] - x[planet] - *closing) > kShiftTolerance) {
      return object(name, "it does not fit the centre distance of sun and planet");
    }
    LoadedMesh mesh{name,
                    {planet_name, ring_name},
                    {is_first, false},
                    {},
                    0,
                    {},
                    train_.face_width_mm[is_first ? 0 : 1],
                    force_N};
    const double tip = is_first ? tip_diameter_planet_1(z_[1], x[1], x[0], increment_)
                                : tip_diameter_external(z_[planet], x[planet]);
    mesh.cut = {pair, *angle, tip, tip_diameter_ring(z_[ring], x[ring])};
    add(mesh);
  }

  double working_radius_m(std::size_t gear, double teeth_between) const {
    return train_.module_mm * 1e-3 * centre_ * z_[gear] / teeth_between;
  }
  double centre_m() const { return train_.module_mm * 1e-3 * centre_; }

  LoadedTrain finish() {
    const std::vector<GearCutter> cutters = gear_cutters(train_);
    for (LoadedMesh& mesh : train_built_.meshes) {
      for (const std::size_t which : {0u, 1u}) {
        for (const GearCutter& cutter : cutters) {
          if (cutter.gear == mesh.gears[which]) mesh.cutter_tip_radius[which] = cutter.tip_radius;
        }
      }
    }
    return std::move(train_built_);
  }

 private:
  ShiftedPair external_pair() const {
    return {MeshKind::kExternal, z_[0], z_[1], train_.shifts[0], train_.shifts[1]};
  }

  void object(std::string_view mesh, const char* why) {
    train_built_.objections.push_back(
        fmt::format("{} do not mesh for teeth {}: {}", mesh, fmt::join(train_.teeth, ","), why));
  }

  void add(LoadedMesh mesh) {
    const ShiftedPair& pair = mesh.cut.pair;
    if (pair.teeth_1 < kFewestTeeth || pair.teeth_2 < kFewestTeeth) {
      return object(mesh.name, "stresses are computed for eight teeth and more");
    }
    const auto path = contact_path(mesh.cut);
    if (!path || !(contact_ratio(*path) >= 1.0)) {
      return object(mesh.name, "the contact ratio would be below 1");
    }
    // From the base circles' tangent points to the pitch point, in base pitches.
    const double pitch = std::tan(mesh.cut.working_angle_rad) / (2.0 * std::numbers::pi);
    const bool is_internal = pair.kind == MeshKind::kInternal;
    if (path->approach > pair.teeth_1 * pitch ||
        (!is_internal && path->recess > pair.teeth_2 * pitch)) {
      return object(mesh.name, "contact would reach inside a base circle (undercut)");
    }
    mesh.contact_ratio = contact_ratio(*path);
    train_built_.meshes.push_back(mesh);
  }

  const GearTrain& train_;
  const std::vector<double> z_;
  double sun_angle_rad_ = 0.0;
  double centre_ = 0.0;     // in modules
  double increment_ = 0.0;  // likewise
  LoadedTrain train_built_;
};

LoadedTrain loaded_three_k(const GearTrain& train, MeshBuilder& builder) {
  const ThreeKTeeth<double> teeth = three_k_teeth(train);
  const double ratio = reduction(train);
  const ThreeKLoads loads =
      three_k_loads(ratio, ratio, train.planet_count, working_radii(teeth, builder.centre_m()));
  builder.add_sun_mesh("sun_planet_1", "planet_1", std::abs(loads.sun_force_N));
  builder.add_ring_mesh("planet_1_fixed_ring", 1, "planet_1", 3, "fixed_ring",
                        std::abs(loads.fixed_ring_force_N));
  builder.add_ring_mesh("planet_2_output_ring", 2, "planet_2", 4, "output_ring",
                        std::abs(loads.output_ring_force_N));
  return builder.finish();
}

LoadedTrain loaded_planetary(const GearTrain& train, MeshBuilder& builder) {
  const double ratio = reduction(train);
  const double teeth = static_cast<double>(train.teeth[0] + train.teeth[1]);
  const PlanetaryLoads loads =
      planetary_loads(ratio, ratio, train.planet_count, builder.working_radius_m(0, teeth));
  builder.add_sun_mesh("sun_planet", "planet", loads.tooth_force_N);
  builder.add_ring_mesh("planet_ring", 1, "planet", 2, "ring", loads.tooth_force_N);
  return builder.finish();
}

}  // namespace

std::size_t layer_count(std::string_view topology) { return topology == "3k" ? 2 : 1; }

double reduction(const GearTrain& train) {
  if (train.topology == "3k") return three_k_reduction(three_k_teeth(train));
  const std::vector<double> z = real_teeth(train);
  return planetary_reduction(PlanetaryTeeth<double>{z[0], z[1], z[2]});
}

LoadedTrain loaded_train(const GearTrain& train) {
  MeshBuilder builder(train);
  if (!builder.can_mesh()) return builder.finish();
  if (!std::isfinite(reduction(train))) {
    return {{},
            {fmt::format("the teeth {} have no ratio: the output ring stands still",
                         fmt::join(train.teeth, ","))}};
  }
  return train.topology == "3k" ? loaded_three_k(train, builder) : loaded_planetary(train, builder);
}

std::vector<std::string> objections(const GearTrain& train) {
  std::vector<std::string> list = loaded_train(train).objections;
  for (const ConstraintReport& violated : what_cannot_exist(train)) {
    list.push_back(violated.sentence);
  }
  return list;
}

}  // namespace torquewright::gearbox
