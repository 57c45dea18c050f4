// SPDX-License-Identifier: Apache-2.0
#include "gearbox/topologies/shifted_train.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <stdexcept>

#include "gearbox/constraints/condition.hpp"
#include "gearbox/constraints/existence.hpp"
#include "gearbox/constraints/shifted_gears.hpp"
#include "gearbox/topologies/report_parts.hpp"
#include "gearbox/train/central_gears.hpp"
#include "gearbox/train/inertia.hpp"
#include "gearbox/train_parts.hpp"
#include "gearbox/walls.hpp"

namespace torquewright::gearbox {
namespace {

std::span<const CutMesh> ring_meshes(const CutTrain& cut) {
  return std::span(cut.meshes).subspan(1);
}

/// One for each layer: sizes follow from its module.
struct LayerBlanks {
  Blank first;
  Blank second;

  const Blank& of(const CutGear& gear) const { return gear.layer == 0 ? first : second; }
  double width_m(const CutGear& gear) const {
    return gear.layer == 0 ? first.face_width_1_m : second.face_width_2_m;
  }
};

std::optional<LayerBlanks> layer_blanks(const Problem& problem, const CutTrain& cut) {
  const std::vector<std::string> layers = train_parts(problem.topology).layer_names();
  const auto blank = [&](std::size_t layer) {
    return blank_of(problem, io::exact(cut.train.module_of_layer_mm(layer)), layers);
  };
  const auto first = blank(0);
  if (!first) return std::nullopt;
  return LayerBlanks{*first, *blank(layers.size() - 1)};
}

bool is_planet(const CutTrain& cut, const CutGear& gear) {
  return !gear.internal && &gear != &cut.gears.front();
}

double mass_kg(const LayerBlanks& blanks, const CutTrain& cut, const CutGear& gear) {
  const Blank& blank = blanks.of(gear);
  const double size = gear.middle_diameter();
  if (gear.internal) return ring_mass_kg(blank, blanks.width_m(gear), size);
  return is_planet(cut, gear) ? disc_mass_kg(blank, blanks.width_m(gear), size)
                              : sun_mass_kg(blank, size);
}

double inertia_kg_m2(const LayerBlanks& blanks, const CutTrain& cut, const CutGear& gear) {
  const Blank& blank = blanks.of(gear);
  const double size = gear.middle_diameter();
  if (gear.internal) return ring_inertia_kg_m2(blank, blanks.width_m(gear), size);
  return is_planet(cut, gear) ? disc_inertia_kg_m2(blank, blanks.width_m(gear), size)
                              : sun_inertia_kg_m2(blank, size);
}

/// Kinetic energy over half the square of the sun's speed: every gear turns with its own speed,
/// planets run with the carrier too.
double inertia_at_sun_kg_m2(const Problem& problem, const LayerBlanks& blanks, const CutTrain& cut,
                            const DesignReport& report) {
  double sum = io::nearest(problem.rotor_inertia_kg_m2);
  for (std::size_t i = 0; i < cut.gears.size(); ++i) {
    const CutGear& gear = cut.gears[i];
    double own = inertia_kg_m2(blanks, cut, gear) * square(report.gears[i].speed_per_input);
    if (is_planet(cut, gear)) {
      own += mass_kg(blanks, cut, gear) *
             square(cut.centre_mm * 1e-3 * report.carrier_speed_per_input);
      own *= static_cast<double>(cut.train.planet_count);
    }
    sum += own;
  }
  return sum;
}

}  // namespace

std::string shift_objection(const Problem& problem, const Design& design) {
  if (!design.is_shifted() || cut_train(gear_train(problem, design))) return "";
  return fmt::format(
      "the profile shifts {} of sun and planet leave no working angle: inv(alpha_w) would be "
      "negative; their sum must be greater",
      fmt::join(std::span(design.profile_shift).first(2), ", "));
}

std::optional<CutTrain> cut_of(const Problem& problem, const Design& design) {
  if (!design.is_shifted()) return std::nullopt;
  auto cut = cut_train(gear_train(problem, design));
  if (!cut) throw std::invalid_argument(shift_objection(problem, design));
  return cut;
}

std::vector<GearReport> describe_gears(const CutTrain& cut, const std::vector<double>& speeds) {
  std::vector<GearReport> list;
  for (std::size_t i = 0; i < cut.gears.size(); ++i) {
    const CutGear& gear = cut.gears[i];
    GearReport report;
    report.name = gear.name;
    report.teeth = gear.teeth;
    report.layer = gear.layer == 0 ? "layer_1" : "layer_2";
    report.internal = gear.internal;
    report.module_mm = gear.module_mm;
    report.profile_shift = gear.shift;
    report.pitch_diameter_mm = gear.module_mm * gear.count();
    report.tip_diameter_mm = gear.module_mm * gear.tip_diameter;
    report.root_diameter_mm = gear.module_mm * gear.root_diameter();
    report.base_diameter_mm = gear.module_mm * gear.base_diameter();
    report.speed_per_input = speeds[i];
    list.push_back(std::move(report));
  }
  return list;
}

std::vector<ContactPath<double>> contact_paths(const CutTrain& cut) {
  std::vector<ContactPath<double>> paths;
  for (const CutMesh& mesh : cut.meshes) paths.push_back(contact_path_of(mesh));
  return paths;
}

void state_working_angles(const CutTrain& cut, DesignReport& report) {
  report.centre_distance_mm = cut.centre_mm;
  for (std::size_t i = 0; i < cut.meshes.size(); ++i) {
    if (cut.meshes[i].cut)
      report.meshes[i].working_angle_rad = cut.meshes[i].cut->working_angle_rad;
  }
}

double base_radius_mm(const CutGear& gear) { return gear.module_mm * gear.base_diameter() / 2.0; }

void describe_shifted_bodies(const Problem& problem, const CutTrain& cut, DesignReport& report) {
  const CutGear& sun = cut.gears.front();
  const Rational module_mm = io::exact(sun.module_mm);
  report.hollow_shaft_diameter_mm = sun.module_mm * sun.root_diameter() -
                                    2.0 * io::nearest(hollow_shaft_wall_mm(problem, module_mm));
  for (const CutGear& gear : cut.gears) {
    if (!gear.internal) continue;
    const Rational blank_mm =
        ring_blank_mm(problem, io::exact(gear.module_mm), fraction_of(gear.middle_diameter()));
    report.ring_blank_diameter_mm = std::max(report.ring_blank_diameter_mm, io::nearest(blank_mm));
  }
  const auto blanks = layer_blanks(problem, cut);
  if (!blanks) return;
  double sum_kg = 0.0;
  for (const CutGear& gear : cut.gears) {
    const double count = is_planet(cut, gear) ? static_cast<double>(cut.train.planet_count) : 1.0;
    sum_kg += count * mass_kg(*blanks, cut, gear);
  }
  report.mass_kg = sum_kg;
  if (report.ratio == 0) return;
  report.reflected_inertia_kg_m2 = reflected_inertia_kg_m2(
      io::nearest(report.ratio), inertia_at_sun_kg_m2(problem, *blanks, cut, report));
}

std::vector<ConstraintReport> shifted_conditions(const Problem& problem, const CutTrain& cut) {
  std::vector<ConstraintReport> list;
  const TrainParts& parts = train_parts(problem.topology);
  for (std::size_t gear = 1; gear < parts.free_gears; ++gear) {
    list.push_back(neighbour_clearance(cut.gears[gear], cut.centre_mm, cut.train.planet_count,
                                       problem.min_neighbour_clearance_mm));
  }
  if (!parts.ring_of_layer(0)) list.push_back(planet_room(problem, cut.gears[1], cut.centre_mm));
  for (const CutGear& gear : cut.gears) {
    if (!gear.internal) list.push_back(undercut(cut.train.cutters, gear));
  }
  if (may_sun_pass(parts) && problem.sun_under_second_layer) {
    list.push_back(sun_under_layer_2(cut));
  }
  for (const CutGear& gear : cut.gears) {
    if (!gear.internal) continue;
    list.push_back(ring_wall(problem, gear));
    list.push_back(ring_tip(gear));
  }
  for (const CutMesh& mesh : ring_meshes(cut)) {
    list.push_back(involute_interference(mesh));
    list.push_back(trochoid_interference(mesh));
  }
  for (const CutMesh& mesh : cut.meshes) list.push_back(contact_ratio_limit(problem, mesh));
  list.push_back(
      external_root_form(cut, cut.meshes.front(), cut.train.cutters.hob_tip_radius.value_or(0.0)));
  for (const CutMesh& mesh : cut.meshes) list.push_back(bottom_clearance(cut, mesh));
  if (cut.train.cutters.shaper_teeth) {
    for (const CutMesh& mesh : ring_meshes(cut)) list.push_back(shaper_feed(cut, mesh));
  }
  for (ConstraintReport& condition : existence_conditions(cut.train)) {
    const bool is_listed = condition.name == "equal_spacing" ||
                           std::any_of(list.begin(), list.end(), [&](const ConstraintReport& each) {
                             return each.name == condition.name;
                           });
    if (!is_listed) list.push_back(std::move(condition));
  }
  return list;
}

std::vector<ConstraintReport> shifted_coaxiality(const CutTrain& cut) {
  std::vector<ConstraintReport> list;
  for (const CutMesh& mesh : ring_meshes(cut)) list.push_back(coaxiality(cut, mesh));
  return list;
}

}  // namespace torquewright::gearbox
