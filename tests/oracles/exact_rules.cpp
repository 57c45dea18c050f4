// SPDX-License-Identifier: Apache-2.0
#include <numeric>
#include <stdexcept>

#include "tests/oracles/rule_families.hpp"

namespace torquewright::oracles {
namespace {

using Count = std::int64_t Teeth::*;

Judgement exactly(bool holds) { return {holds, false, 0}; }

std::int64_t minimum(const gearbox::Problem& problem, const std::string& gear) {
  const auto found = problem.min_teeth.find(gear);
  return found == problem.min_teeth.end() ? 1 : found->second;
}

Rule at_least(std::string name, Count count, std::int64_t least) {
  return {std::move(name),
          [count, least](const Teeth& teeth) { return exactly(teeth.*count >= least); }};
}

Rule at_most(std::string name, Count count, std::int64_t most) {
  return {std::move(name),
          [count, most](const Teeth& teeth) { return exactly(teeth.*count <= most); }};
}

Rule ratio_rule(const gearbox::Problem& problem) {
  const RatioRange range = ratio_range(problem);
  const auto ratio = is_3k(problem) ? ratio_3k : ratio_planetary;
  return {"ratio", [range, ratio](const Teeth& teeth) {
            const auto [p, q] = ratio(teeth);
            return exactly(q > 0 && compare(p, q, range.least) >= 0 &&
                           compare(p, q, range.greatest) <= 0);
          }};
}

Rule equal_spacing(std::int64_t planets) {
  return {"equal_spacing", [planets](const Teeth& teeth) {
            return exactly((teeth.sun + teeth.fixed_ring) % planets == 0);
          }};
}

Rule tooth_difference(std::int64_t planets) {
  return {"tooth_difference", [planets](const Teeth& teeth) {
            return exactly(teeth.planet_1 - teeth.planet_2 >= planets);
          }};
}

Rule identical_planets(std::int64_t planets) {
  return {"identical_planets", [planets](const Teeth& teeth) {
            const std::int64_t turns =
                teeth.output_ring * teeth.planet_1 - teeth.fixed_ring * teeth.planet_2;
            return exactly(turns % (planets * std::gcd(teeth.planet_1, teeth.planet_2)) == 0);
          }};
}

// (D_out - m (z + 2 h))/2 >= wall solved for z; the rotor's bore stands for a D_out not stated.
std::int64_t largest_walled_ring(const Setting& setting) {
  const gearbox::Problem& problem = setting.problem;
  const Rational& module = setting.module_mm;
  const Rational wall = problem.ring_wall_mm.value_or(Rational(9, 4) * module);
  const auto& stated = problem.ring_outer_diameter_mm;
  const Rational space = stated ? *stated : problem.rotor_inner_diameter_mm;
  return floor_of((space - 2 * wall) / module -
                  2 * problem.cutters.shaper_addendum.value_or(Rational(5, 4)));
}

void add_size_rules(const Setting& setting, std::vector<Rule>& list) {
  const gearbox::Problem& problem = setting.problem;
  const std::int64_t bore = floor_of(problem.rotor_inner_diameter_mm / setting.module_mm);
  list.push_back(at_least("min_teeth.sun", &Teeth::sun, minimum(problem, "sun")));
  if (is_3k(problem)) {
    list.push_back(at_least("min_teeth.planet_1", &Teeth::planet_1, minimum(problem, "planet_1")));
    list.push_back(at_least("min_teeth.planet_2", &Teeth::planet_2, minimum(problem, "planet_2")));
    list.push_back(tooth_difference(setting.planet_count));
  } else {
    list.push_back(at_least("min_teeth.planet", &Teeth::planet_1, minimum(problem, "planet")));
  }
  list.push_back(at_most("rotor_bore", &Teeth::fixed_ring, bore));
}

void add_buildable_rules(const Setting& setting, std::vector<Rule>& list) {
  const gearbox::Problem& problem = setting.problem;
  const std::int64_t most = largest_walled_ring(setting);
  if (!is_3k(problem)) {
    list.push_back(at_most("ring_wall.ring", &Teeth::fixed_ring, most));
    return;
  }
  list.push_back(identical_planets(setting.planet_count));
  if (problem.sun_under_second_layer) {
    list.push_back({"sun_under_layer_2", [](const Teeth& teeth) {
                      return exactly(teeth.planet_1 - teeth.planet_2 > 4);
                    }});
  }
  list.push_back(at_most("ring_wall.fixed_ring", &Teeth::fixed_ring, most));
  list.push_back(at_most("ring_wall.output_ring", &Teeth::output_ring, most));
}

}  // namespace

std::vector<Rule> exact_rules(const Setting& setting) {
  if (!is_3k(setting.problem) && !is_buildable(setting.problem)) {
    throw std::invalid_argument("the paper's constraints are those of a 3k train");
  }
  std::vector<Rule> list;
  add_size_rules(setting, list);
  list.push_back(equal_spacing(setting.planet_count));
  list.push_back(ratio_rule(setting.problem));
  if (is_buildable(setting.problem)) add_buildable_rules(setting, list);
  return list;
}

}  // namespace torquewright::oracles
