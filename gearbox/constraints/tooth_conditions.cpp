// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/tooth_conditions.hpp"

#include "gearbox/constraints/root_form.hpp"
#include "gearbox/teeth/mesh.hpp"
#include "gearbox/teeth/root_form.hpp"
#include "gearbox/teeth/shaper_feed.hpp"
#include "gearbox/walls.hpp"

namespace torquewright::gearbox {
namespace {

Expression constant(std::int64_t number) { return Expression(static_cast<double>(number)); }
Expression half_pitch_angle(std::int64_t planet_count) {
  return Expression::pi() / constant(planet_count);
}

Expression straight_depth(const StatedCutters& cutters, const Rational& tip_radius) {
  return straight_depth_of_hob(Expression(cutters.hob_depth()), Expression(tip_radius));
}

/// As constraints/gear_cutters.hpp has it.
Expression undercut_depth(const StatedCutters& cutters) {
  if (cutters.hob_tip_radius) return straight_depth(cutters, *cutters.hob_tip_radius);
  if (!cutters.hob_addendum) return Expression(1.0);
  return max(straight_depth(cutters, Rational(19, 50)), 1.0);
}

Expression reference_angle() { return Expression::pi() / 9.0; }

}  // namespace

Rational least_ratio(const Problem& problem) {
  return problem.target_ratio * (1 - problem.ratio_tolerance);
}
Rational greatest_ratio(const Problem& problem) {
  return problem.target_ratio * (1 + problem.ratio_tolerance);
}

Condition at_least(const std::string& gear, const Expression& teeth, std::int64_t minimum) {
  const std::string name = "min_teeth." + gear;
  return {name, name, "/min_teeth/" + gear, teeth - constant(minimum)};
}

Condition carrier_clearance(const Problem& problem, std::int64_t planet_count,
                            const Expression& sun, const Expression& planet) {
  const Expression k =
      sin(half_pitch_angle(planet_count) - Expression(problem.min_carrier_clearance_rad));
  return {"carrier_clearance", "carrier_clearance", "/min_carrier_clearance_rad",
          k * sun - (1.0 - k) * planet};
}

Expression carrier_clearance_rad(std::int64_t planet_count, const Expression& sun,
                                 const Expression& planet) {
  return half_pitch_angle(planet_count) - asin(planet / (sun + planet));
}

Condition rotor_bore(const Problem& problem, const Rational& module_mm, const Expression& ring) {
  const Rational limit = problem.rotor_inner_diameter_mm / module_mm;
  return {"rotor_bore", "rotor_bore", "/rotor_inner_diameter_mm", Expression(limit) - ring};
}

Condition neighbour_clearance(const Problem& problem, const std::string& layer,
                              std::int64_t planet_count, const Rational& module_mm,
                              const Expression& tooth_sum, const Expression& planet) {
  const std::string name = "neighbour_clearance." + layer;
  const Rational limit = problem.min_neighbour_clearance_mm / module_mm;
  return {name, name, "/min_neighbour_clearance_mm",
          sin(half_pitch_angle(planet_count)) * tooth_sum - (planet + 2.0) - Expression(limit),
          /*strict=*/true};
}

Expression neighbour_clearance_mm(std::int64_t planet_count, const Rational& module_mm,
                                  const Expression& tooth_sum, const Expression& planet) {
  return Expression(module_mm) * (sin(half_pitch_angle(planet_count)) * tooth_sum - (planet + 2.0));
}

Condition undercut(const Problem& problem, const std::string& gear, const Expression& teeth) {
  const std::string name = "undercut." + gear;
  return {name, name, "", teeth - undercut_limit_teeth(undercut_depth(problem.cutters))};
}

Condition ring_tip(const std::string& ring, const Rational& module_mm, const Expression& teeth) {
  const std::string name = "ring_tip." + ring;
  const Expression inside = (1.0 - cos(reference_angle())) * teeth - 2.0;
  return {name, name, "", Expression(module_mm) / 2.0 * inside, /*strict=*/true};
}

Condition ring_wall(const Problem& problem, const std::string& ring, const Rational& module_mm,
                    const Expression& teeth) {
  const std::string name = "ring_wall." + ring;
  const Expression root_mm =
      Expression(module_mm) * (teeth + Expression(Rational(2 * problem.cutters.shaper_depth())));
  const Rational wall_mm = ring_wall_mm(problem, module_mm);
  return {name, name, ring_space_key(problem),
          (Expression(ring_space_mm(problem)) - root_mm) / 2.0 - Expression(wall_mm)};
}

std::vector<Condition> interference(const std::string& mesh, const Expression& planet,
                                    const Expression& ring) {
  const std::string involute = "interference.involute." + mesh;
  const std::string trochoid = "interference.trochoid." + mesh;
  return {{involute, involute, "", involute_interference_margin(planet, ring), false, false},
          {trochoid, trochoid, "",
           min(trochoid_interference_margin(planet, ring), ring_tip_margin(ring)), false, false}};
}

std::vector<Condition> root_form(const Problem& problem, const std::string& mesh,
                                 const Expression& planet, const Expression& ring) {
  std::vector<Condition> result;
  const StatedCutters& cutters = problem.cutters;
  if (cutters.hob_tip_radius || cutters.hob_addendum) {
    const std::string name = "root_form.hob." + mesh;
    const Expression spare =
        straight_depth(cutters, cutters.hob_tip_radius.value_or(0)) - depth_reached_by_ring(ring);
    result.push_back({name, name, "", min(spare, ring_tip_margin(ring))});
  }
  if (cutters.shaper_teeth || (cutters.shaper_addendum && cutters.shaper_tip_radius)) {
    const std::string name = "root_form.shaper." + mesh;
    const Expression shaper = cutters.shaper_teeth ? constant(*cutters.shaper_teeth) : planet;
    const Expression left = path_left_by_shaper(shaper, Expression(cutters.shaper_depth()),
                                                Expression(cutters.shaper_tip_radius.value_or(0)));
    const Expression spare = left - path_reached_by_planet(planet);
    result.push_back({name, name, "", min(spare, ring - shaper - 1.0)});
  }
  if (cutters.shaper_teeth) {
    const std::string name = "shaper_feed." + mesh;
    result.push_back({name, name, "", ring - constant(least_fed_ring(stated_cutters(problem)))});
  }
  return result;
}

std::vector<Condition> root_form_of_gears(const Problem& problem, const std::string& mesh,
                                          const Expression& gear_1, const Expression& gear_2) {
  const StatedCutters& cutters = problem.cutters;
  if (!cutters.hob_tip_radius || !cutters.hob_addendum) return {};
  const std::string name = "root_form.hob." + mesh;
  const Expression depth = straight_depth(cutters, *cutters.hob_tip_radius);
  return {{name, name, "",
           min(depth - depth_reached_by_gear(gear_1), depth - depth_reached_by_gear(gear_2))}};
}

Condition contact_ratio(const Problem& problem, const std::string& mesh, const Expression& gear_1,
                        const Expression& gear_2) {
  const std::string name = "contact_ratio." + mesh;
  return {name, name, "/min_contact_ratio",
          contact_ratio(external_path(gear_1, gear_2)) - Expression(problem.min_contact_ratio)};
}

Condition contact_ratio_in_ring(const Problem& problem, const std::string& mesh,
                                const Expression& planet, const Expression& ring) {
  const std::string name = "contact_ratio." + mesh;
  const Expression spare =
      contact_ratio(internal_path(planet, ring)) - Expression(problem.min_contact_ratio);
  return {name, name, "/min_contact_ratio", min(spare, ring_tip_margin(ring)), false, false};
}

}  // namespace torquewright::gearbox
