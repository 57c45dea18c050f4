// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/root_form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gearbox/teeth/root_form.hpp"
#include "gearbox/teeth/shaper.hpp"
#include "gearbox/teeth/shaper_feed.hpp"

namespace torquewright::gearbox {
namespace {

DesignCondition root_form_condition(std::string name, const Rational& module_mm, double largest,
                                    const std::optional<Rational>& stated) {
  DesignCondition condition{std::move(name), "", "mm"};
  condition.limit = module_mm * stated.value_or(0);
  condition.value = module_mm * fraction_of(largest);
  return condition;
}

ConstraintReport without_mesh(const DesignCondition& condition) {
  return violated_without_value(condition, "does not exist: the gears do not mesh.");
}

std::optional<double> largest_shaper_radius(std::int64_t shaper, double addendum,
                                            std::int64_t planet, std::int64_t ring) {
  const auto z = static_cast<double>(ring);
  const auto p = static_cast<double>(planet);
  const auto at_depth = shaper_at_depth({z, 0.0, z / 2.0 + addendum, static_cast<double>(shaper)});
  if (!at_depth || planet >= ring) return std::nullopt;
  return largest_shaper_tip_radius(*at_depth, {p, 0.0, z, z / 2.0 - 1.0, (z - p) / 2.0},
                                   p / 2.0 + 1.0);
}

}  // namespace

DesignCondition hob_condition(std::string_view mesh, const Rational& module_mm, double largest,
                              const std::optional<Rational>& stated) {
  DesignCondition condition =
      root_form_condition(fmt::format("root_form.hob.{}", mesh), module_mm, largest, stated);
  condition.meaning =
      "of rounding at most on the tip of the hob that leaves the flank down to where the mate's "
      "tip touches it";
  condition.remedy = "needs a sharper hob, or a ring of more teeth";
  return condition;
}

DesignCondition shaper_condition(std::string_view mesh, const Rational& module_mm, double largest,
                                 const std::optional<Rational>& stated, double shaper_teeth) {
  DesignCondition condition =
      root_form_condition(fmt::format("root_form.shaper.{}", mesh), module_mm, largest, stated);
  condition.meaning = fmt::format(
      "of rounding at most on the tip of a shaper of {} teeth that leaves the ring's flank out to "
      "where the planet's tip touches it",
      shaper_teeth);
  condition.remedy = "needs a sharper shaper or one of more teeth, or a smaller planet";
  return condition;
}

std::int64_t least_fed_ring(const Cutters& cutters) {
  return least_fed_ring(*cutters.shaper_teeth, cutters.shaper_depth(),
                        cutters.shaper_tip_radius.value_or(0.0));
}

ConstraintReport shaper_feed(const Problem& problem, std::string_view mesh, std::int64_t ring) {
  const Cutters cutters = stated_cutters(problem);
  DesignCondition condition{fmt::format("shaper_feed.{}", mesh), "", "teeth"};
  condition.value = Rational(ring);
  condition.limit = Rational(least_fed_ring(cutters));
  condition.meaning = fmt::format(
      "on the ring, that a shaper of {} teeth cuts whose tips it does not cut away when it is fed "
      "in radially",
      *cutters.shaper_teeth);
  condition.remedy = "needs a shaper of fewer teeth or a larger ring";
  return judge(condition);
}

ConstraintReport root_form_of_gears(const Problem& problem, const Rational& module_mm,
                                    std::string_view mesh, std::int64_t teeth_1,
                                    std::int64_t teeth_2) {
  const auto larger = static_cast<double>(std::max(teeth_1, teeth_2));
  const double largest = largest_hob_tip_radius_for(io::nearest(problem.cutters.hob_depth()),
                                                    depth_reached_by_gear(larger));
  return judge(hob_condition(mesh, module_mm, largest, problem.cutters.hob_tip_radius));
}

ConstraintReport root_form_of_planet(const Problem& problem, const Rational& module_mm,
                                     std::string_view mesh, std::int64_t ring) {
  const auto teeth = static_cast<double>(ring);
  const double largest = largest_hob_tip_radius_for(io::nearest(problem.cutters.hob_depth()),
                                                    depth_reached_by_ring(teeth));
  const DesignCondition condition =
      hob_condition(mesh, module_mm, largest, problem.cutters.hob_tip_radius);
  return ring_tip_margin(teeth) > 0.0 ? judge(condition) : without_mesh(condition);
}

ConstraintReport root_form_of_ring(const Problem& problem, const Rational& module_mm,
                                   std::string_view mesh, std::int64_t planet, std::int64_t ring) {
  const std::int64_t shaper = problem.cutters.shaper_teeth.value_or(planet);
  const auto largest =
      largest_shaper_radius(shaper, io::nearest(problem.cutters.shaper_depth()), planet, ring);
  const DesignCondition condition =
      shaper_condition(mesh, module_mm, largest.value_or(0.0), problem.cutters.shaper_tip_radius,
                       static_cast<double>(shaper));
  return largest ? judge(condition) : without_mesh(condition);
}

}  // namespace torquewright::gearbox
