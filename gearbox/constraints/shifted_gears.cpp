// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/shifted_gears.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearbox/constraints/condition.hpp"
#include "gearbox/constraints/cut_ring.hpp"
#include "gearbox/constraints/hob_reach.hpp"
#include "gearbox/teeth/root_form.hpp"
#include "gearbox/teeth/shaper_feed.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"
#include "gearbox/walls.hpp"

namespace torquewright::gearbox {
namespace {

Rational length_mm(const CutGear& gear, double modules) {
  return io::exact(gear.module_mm) * fraction_of(modules);
}

double radius_mm(const CutGear& gear, double diameter) { return gear.module_mm * diameter / 2.0; }

/// A margin that two gears in mesh have, or the sentence that they do not mesh.
ConstraintReport mesh_margin(DesignCondition condition, const CutMesh& mesh,
                             std::optional<double> (*margin)(const CutPair&)) {
  const auto value = mesh.cut ? margin(*mesh.cut) : std::nullopt;
  if (!value || !std::isfinite(*value)) {
    return violated_without_value(
        condition, "does not exist: with these shifts planet and ring do not mesh there.");
  }
  condition.value = fraction_of(*value);
  return judge(condition);
}

}  // namespace

ConstraintReport coaxiality(const CutTrain& train, const CutMesh& mesh) {
  const CutGear& ring = train.gears[mesh.gear_2];
  DesignCondition condition{fmt::format("coaxial.{}", ring.name), "", "modules", Sense::kAtMost};
  condition.limit = io::exact(kCoaxialTolerance);
  if (!mesh.closing_ring_shift) {
    return violated_without_value(
        condition, fmt::format("no profile shift closes the centre distance of {:.6g} mm with {} "
                               "teeth; needs other teeth or another module.",
                               train.centre_mm, ring.teeth));
  }
  condition.value = fraction_of(std::abs(ring.shift - *mesh.closing_ring_shift));
  condition.meaning = fmt::format(
      "between this ring's shift and the one that meshes without backlash at the centre distance "
      "of sun and planet, {:.7g} mm",
      train.centre_mm);
  condition.remedy = fmt::format("needs the shift {:.6f}", *mesh.closing_ring_shift);
  return judge(condition);
}

ConstraintReport neighbour_clearance(const CutGear& planet, double centre_mm,
                                     std::int64_t planet_count, const Rational& minimum_mm) {
  DesignCondition condition{fmt::format("neighbour_clearance.layer_{}", planet.layer + 1),
                            "/min_neighbour_clearance_mm", "mm", Sense::kMoreThan};
  const double chord_mm =
      2.0 * centre_mm * std::sin(std::numbers::pi / static_cast<double>(planet_count));
  condition.value = fraction_of(chord_mm) - length_mm(planet, planet.tip_diameter);
  condition.limit = minimum_mm;
  condition.meaning = "between the tips of neighbouring planets";
  condition.remedy = "needs fewer planets, smaller ones or a longer centre distance";
  return judge(condition);
}

ConstraintReport undercut(const Cutters& cutters, const CutGear& gear) {
  DesignCondition condition{fmt::format("undercut.{}", gear.name), "", "teeth"};
  const double depth = undercut_depth(cutters);
  const double limit = undercut_limit_teeth(depth);
  condition.value = Rational(gear.teeth);
  condition.limit = fraction_of(limit * (1.0 - gear.shift / depth));
  condition.meaning = fmt::format("on this gear, shifted by {:.6g} modules", gear.shift);
  condition.remedy = fmt::format("needs a profile shift of at least {:.3g} modules",
                                 depth * (1.0 - gear.count() / limit));
  return judge(condition);
}

ConstraintReport sun_under_layer_2(const CutTrain& train) {
  const CutGear& sun = train.gears[0];
  const CutGear& planet_2 = train.gears[2];
  DesignCondition condition{"sun_under_layer_2", "", "mm", Sense::kMoreThan};
  condition.value = fraction_of(train.centre_mm - radius_mm(sun, sun.tip_diameter) -
                                radius_mm(planet_2, planet_2.tip_diameter));
  condition.meaning = "between the tips of sun and planet 2, where the sun reaches under it";
  condition.remedy = "needs a smaller planet 2 or a sun that ends before the second layer";
  return judge(condition);
}

ConstraintReport planet_room(const Problem& problem, const CutGear& planet, double centre_mm) {
  DesignCondition condition{fmt::format("planet_room.{}", planet.name), ring_space_key(problem),
                            "mm", Sense::kAtMost};
  condition.value = fraction_of(2.0 * centre_mm) + length_mm(planet, planet.tip_diameter);
  condition.limit = ring_space_mm(problem);
  condition.meaning = "across the tips of opposite planets, which no ring encloses";
  condition.remedy = "needs a smaller planet or a shorter centre distance";
  return judge(condition);
}

ConstraintReport ring_wall(const Problem& problem, const CutGear& ring) {
  DesignCondition condition{fmt::format("ring_wall.{}", ring.name), ring_space_key(problem), "mm"};
  const Rational root_mm = length_mm(ring, ring.root_diameter());
  condition.value = (ring_space_mm(problem) - root_mm) / 2;
  condition.limit = ring_wall_mm(problem, io::exact(ring.module_mm));
  condition.meaning = "of wall behind the ring's root";
  condition.remedy = fmt::format("needs a blank of {} or fewer teeth",
                                 with_unit(root_mm + 2 * condition.limit, "mm"));
  return judge(condition);
}

ConstraintReport ring_tip(const CutGear& ring) {
  DesignCondition condition{fmt::format("ring_tip.{}", ring.name), "", "mm", Sense::kMoreThan};
  condition.value = length_mm(ring, (ring.tip_diameter - ring.base_diameter()) / 2.0);
  condition.meaning = "from the ring's base circle out to its tip circle";
  condition.remedy = "needs more teeth or more profile shift";
  return judge(condition);
}

ConstraintReport involute_interference(const CutMesh& mesh) {
  DesignCondition condition{fmt::format("interference.involute.{}", mesh.name), "", "1"};
  condition.meaning = "of the ring's size from its tip to the end of the planet's involute";
  condition.remedy = "needs a larger planet, a larger ring or another profile shift";
  return mesh_margin(condition, mesh, involute_interference_margin);
}

ConstraintReport trochoid_interference(const CutMesh& mesh) {
  DesignCondition condition{fmt::format("interference.trochoid.{}", mesh.name), "", "rad"};
  condition.meaning = "between the tips of planet and ring where they leave each other";
  condition.remedy = "needs more teeth between planet and ring, or other profile shifts";
  return mesh_margin(condition, mesh, trochoid_interference_margin);
}

ContactPath<double> contact_path_of(const CutMesh& mesh) {
  const auto path = mesh.cut ? contact_path(*mesh.cut) : std::nullopt;
  return path.value_or(ContactPath<double>{0.0, 0.0});
}

ConstraintReport contact_ratio_limit(const Problem& problem, const CutMesh& mesh) {
  DesignCondition condition{fmt::format("contact_ratio.{}", mesh.name), "/min_contact_ratio", "1"};
  condition.limit = problem.min_contact_ratio;
  const ContactPath<double> path = contact_path_of(mesh);
  if (path.approach == 0.0 && path.recess == 0.0) {
    return violated_without_value(condition, "does not exist: the gears do not mesh.");
  }
  condition.value = fraction_of(contact_ratio(path));
  condition.meaning = "pairs of teeth in contact on average";
  condition.remedy = "needs more teeth, longer teeth or less profile shift";
  return judge(condition);
}

ConstraintReport bottom_clearance(const CutTrain& train, const CutMesh& mesh) {
  const CutGear& first = train.gears[mesh.gear_1];
  const CutGear& second = train.gears[mesh.gear_2];
  const double sign = second.internal ? -1.0 : 1.0;
  const auto gap_mm = [&](double diameter_1, double diameter_2) {
    return sign * (train.centre_mm - radius_mm(second, diameter_2)) - radius_mm(first, diameter_1);
  };
  // Outside both are a - r_1 - r_2; in a ring its root lies beyond the planet's tip, its tip beyond
  // the planet's root: r_2 - a - r_1.
  const double at_root_1_mm = gap_mm(first.root_diameter(), second.tip_diameter);
  const double at_root_2_mm = gap_mm(first.tip_diameter, second.root_diameter());
  const bool at_first = at_root_1_mm < at_root_2_mm;
  DesignCondition condition{fmt::format("bottom_clearance.{}", mesh.name), "", "mm",
                            Sense::kMoreThan};
  condition.value = fraction_of(std::min(at_root_1_mm, at_root_2_mm));
  condition.meaning =
      fmt::format("between the root of {} and the tip of {}", at_first ? first.name : second.name,
                  at_first ? second.name : first.name);
  condition.remedy = "needs other profile shifts";
  return judge(condition);
}

ConstraintReport shaper_feed(const CutTrain& train, const CutMesh& mesh) {
  const CutGear& ring = train.gears[mesh.gear_2];
  DesignCondition condition{fmt::format("shaper_feed.{}", mesh.name), "", "rad"};
  condition.meaning =
      "at the ring between its tips and those of the shaper that is fed in radially";
  condition.remedy = "needs a shaper of fewer teeth or a larger ring";
  const auto shaper = shaper_of(train, mesh);
  const auto margin = shaper
                          ? feed_margin_rad({shaper->teeth, shaper->tip_radius,
                                             train.train.cutters.shaper_tip_radius.value_or(0.0)},
                                            {ring.count(), ring.shift, ring.tip_diameter / 2.0})
                          : std::nullopt;
  if (!margin) {
    return violated_without_value(condition,
                                  "does not exist: the shaper does not fit into this ring.");
  }
  condition.value = fraction_of(*margin);
  return judge(condition);
}

ConstraintReport external_root_form(const CutTrain& train, const CutMesh& mesh,
                                    double hob_tip_radius) {
  DesignCondition condition{fmt::format("root_form.hob.{}", mesh.name), "", "mm"};
  const CutGear& sun = train.gears[mesh.gear_1];
  const auto largest = largest_hob_tip_radii(train, mesh);
  if (!largest) {
    return violated_without_value(
        condition,
        "does not exist: a tip reaches inside the base circle of its mate; needs other shifts.");
  }
  condition.value = length_mm(sun, std::min((*largest)[0], (*largest)[1]));
  condition.limit = length_mm(sun, hob_tip_radius);
  condition.meaning =
      "of rounding at most on the tip of the hob that leaves the flanks of sun and planet down to "
      "where the mate's tip touches them";
  condition.remedy = "needs a sharper hob or other profile shifts";
  return judge(condition);
}

}  // namespace torquewright::gearbox
