// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/teeth.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gearbox/constraints/condition.hpp"
#include "gearbox/constraints/gear_cutters.hpp"
#include "gearbox/teeth/root_form.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"
#include "gearbox/walls.hpp"

namespace torquewright::gearbox {

namespace {

/// The edge of the window that the reduction violates or lies nearest to.
Rational window_edge(const Problem& problem, const Rational& reduction) {
  const Rational half = abs(problem.target_ratio) * problem.ratio_tolerance;
  return reduction < problem.target_ratio ? Rational(problem.target_ratio - half)
                                          : Rational(problem.target_ratio + half);
}

std::string ratio_sentence(const Problem& problem, const Rational& reduction,
                           const Rational& margin) {
  const std::string window =
      problem.ratio_tolerance == 0
          ? fmt::format("exactly {} is asked for", with_unit(problem.target_ratio, "1"))
          : fmt::format("{} within {:.4g} % is asked for", with_unit(problem.target_ratio, "1"),
                        io::nearest(problem.ratio_tolerance) * 100.0);
  const std::string value =
      reduction.get_den() == 1
          ? reduction.get_str()
          : fmt::format("{} = {:.6g}", reduction.get_str(), io::nearest(reduction));
  const std::string head =
      fmt::format("ratio: {} turns of the sun per turn of the output; {}", value, window);
  if (margin == 0) return head + ": met exactly.";
  if (margin > 0) return head + fmt::format(": {:.3g} to spare.", io::nearest(margin));
  const Rational error = (reduction - problem.target_ratio) / abs(problem.target_ratio);
  return head + fmt::format(": off by {:.3g} %; needs a tolerance of {:.4g} or other teeth.",
                            io::nearest(error) * 100.0, io::nearest(Rational(abs(error))));
}

}  // namespace

ConstraintReport ratio_window(const Problem& problem, const Rational& reduction, bool exists) {
  ConstraintReport report;
  report.name = std::string("ratio");
  report.key = std::string("/ratio_tolerance");
  report.unit = std::string("1");
  if (!exists) {
    const DesignCondition condition{"ratio", "/ratio_tolerance",  "1", Sense::kAtLeast,
                                    0,       problem.target_ratio};
    return violated_without_value(
        condition,
        "does not exist, the output stands still (O P1 = F P2); needs P1 and P2 to differ.");
  }
  const Rational margin =
      abs(problem.target_ratio) * problem.ratio_tolerance - abs(reduction - problem.target_ratio);
  report.value = io::nearest(reduction);
  report.limit = io::nearest(window_edge(problem, reduction));
  report.margin = io::nearest(margin);
  report.satisfied = margin >= 0;
  report.sentence = ratio_sentence(problem, reduction, margin);
  return report;
}

ConstraintReport minimum_teeth(const Problem& problem, const std::string& gear,
                               std::int64_t teeth) {
  const auto given = problem.min_teeth.find(gear);
  DesignCondition condition{fmt::format("min_teeth.{}", gear), fmt::format("/min_teeth/{}", gear),
                            "teeth"};
  condition.value = Rational(teeth);
  condition.limit = Rational(given == problem.min_teeth.end() ? 1 : given->second);
  condition.meaning = "on this gear";
  condition.remedy = "needs more teeth or a lower minimum";
  return judge(condition);
}

ConstraintReport rotor_bore(const Problem& problem, const Rational& module_mm, std::int64_t ring) {
  DesignCondition condition{"rotor_bore", "/rotor_inner_diameter_mm", "mm", Sense::kAtMost};
  condition.value = module_mm * ring;
  condition.limit = problem.rotor_inner_diameter_mm;
  condition.meaning = "pitch diameter of the held ring inside the rotor";
  const Rational whole = problem.rotor_inner_diameter_mm / module_mm;
  condition.remedy = fmt::format("needs a ring of at most {} teeth at this module",
                                 mpz_class(whole.get_num() / whole.get_den()).get_str());
  return judge(condition);
}

ConstraintReport tooth_difference(std::int64_t planet_1, std::int64_t planet_2,
                                  std::int64_t planet_count) {
  DesignCondition condition{"tooth_difference", "", "teeth"};
  condition.value = Rational(planet_1 - planet_2);
  condition.limit = Rational(planet_count);
  condition.meaning = "between planet 1 and planet 2";
  condition.remedy = fmt::format("needs P2 <= {} or fewer planets", planet_1 - planet_count);
  return judge(condition);
}

ConstraintReport undercut(const Problem& problem, std::string_view gear, std::int64_t teeth) {
  DesignCondition condition{fmt::format("undercut.{}", gear), "", "teeth"};
  const double depth = undercut_depth(stated_cutters(problem));
  const double limit = undercut_limit_teeth(depth);
  condition.value = Rational(teeth);
  condition.limit = fraction_of(limit);
  condition.meaning = "on this gear";
  condition.remedy =
      fmt::format("needs {:g} teeth or a profile shift of at least {:.3g} modules",
                  std::ceil(limit), depth * (1.0 - static_cast<double>(teeth) / limit));
  return judge(condition);
}

ConstraintReport sun_under_layer_2(const Rational& module_mm, std::int64_t planet_1,
                                   std::int64_t planet_2) {
  DesignCondition condition{"sun_under_layer_2", "", "mm", Sense::kMoreThan};
  condition.value = module_mm * Rational(planet_1 - planet_2 - 4) / 2;
  condition.limit = 0;
  condition.meaning = "between the tips of sun and planet 2, where the sun reaches under it";
  condition.remedy =
      fmt::format("needs P2 <= {} or a sun that ends before the second layer", planet_1 - 5);
  return judge(condition);
}

ConstraintReport ring_wall(const Problem& problem, const Rational& module_mm, std::string_view gear,
                           std::int64_t teeth) {
  const Rational root_mm = module_mm * (Rational(teeth) + 2 * problem.cutters.shaper_depth());
  DesignCondition condition{fmt::format("ring_wall.{}", gear), ring_space_key(problem), "mm"};
  condition.value = (ring_space_mm(problem) - root_mm) / 2;
  condition.limit = ring_wall_mm(problem, module_mm);
  condition.meaning = "of wall behind the ring's root";
  condition.remedy = fmt::format("needs a blank of {} or fewer teeth",
                                 with_unit(root_mm + 2 * condition.limit, "mm"));
  return judge(condition);
}

ConstraintReport ring_tip(const Rational& module_mm, std::string_view gear, std::int64_t teeth) {
  DesignCondition condition{fmt::format("ring_tip.{}", gear), "", "mm", Sense::kMoreThan};
  condition.value = module_mm * fraction_of(ring_tip_margin(static_cast<double>(teeth)));
  condition.limit = 0;
  condition.meaning = "from the ring's base circle out to its tip circle";
  condition.remedy = "needs a ring of at least 34 teeth or profile shift";
  return judge(condition);
}

}  // namespace torquewright::gearbox
