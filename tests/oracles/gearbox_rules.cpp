// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/gearbox_rules.hpp"

#include <stdexcept>

#include "tests/oracles/rule_families.hpp"

namespace torquewright::oracles {
namespace {

bool is_off(const std::string& name, const Switches& off) {
  for (std::size_t end = name.size(); end != std::string::npos; end = name.rfind('.', end - 1)) {
    if (off.contains(name.substr(0, end))) return true;
  }
  return false;
}

WideFraction with_positive_denominator(WideFraction value) {
  return value.denominator < 0 ? WideFraction{-value.numerator, -value.denominator} : value;
}

}  // namespace

bool is_3k(const gearbox::Problem& problem) {
  if (problem.topology == "3k") return true;
  if (problem.topology == "planetary") return false;
  throw std::invalid_argument("unknown topology " + problem.topology);
}

bool is_buildable(const gearbox::Problem& problem) {
  return problem.constraints == gearbox::ConstraintSet::kBuildable;
}

Teeth complete_3k(std::int64_t sun, std::int64_t planet_1, std::int64_t planet_2) {
  return {sun, planet_1, planet_2, sun + 2 * planet_1, sun + planet_1 + planet_2};
}

Teeth complete_planetary(std::int64_t sun, std::int64_t planet) {
  return {sun, planet, 0, sun + 2 * planet, 0};
}

RatioRange ratio_range(const gearbox::Problem& problem) {
  const Rational one_end = problem.target_ratio * (1 - problem.ratio_tolerance);
  const Rational other_end = problem.target_ratio * (1 + problem.ratio_tolerance);
  const bool ascending = one_end <= other_end;
  return {narrow(ascending ? one_end : other_end), narrow(ascending ? other_end : one_end)};
}

WideFraction ratio_3k(const Teeth& teeth) {
  // With the carrier as reference the sun turns -F/S, the output P2 F / (P1 O) times as fast as the
  // fixed ring; add the carrier's own turn and divide.
  const Wide through_planet_1 = Wide{teeth.planet_1} * teeth.output_ring;
  const Wide through_planet_2 = Wide{teeth.planet_2} * teeth.fixed_ring;
  return with_positive_denominator({(teeth.sun + teeth.fixed_ring) * through_planet_1,
                                    teeth.sun * (through_planet_1 - through_planet_2)});
}

WideFraction ratio_planetary(const Teeth& teeth) {
  return {Wide{teeth.sun} + teeth.fixed_ring, Wide{teeth.sun}};
}

std::vector<Rule> rules(const Setting& setting, const Switches& off) {
  std::vector<Rule> enforced = exact_rules(setting);
  for (Rule& rule : real_rules(setting)) enforced.push_back(std::move(rule));
  for (Rule& rule : floor_rules(setting)) enforced.push_back(std::move(rule));
  std::erase_if(enforced, [&off](const Rule& rule) { return is_off(rule.name, off); });
  return enforced;
}

}  // namespace torquewright::oracles
