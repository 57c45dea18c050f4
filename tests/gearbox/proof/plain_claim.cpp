// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "tests/gearbox/proof/naive_proof.hpp"

namespace torquewright::gearbox::proof_test {
namespace {

/// Of the reference: quantities that differ by less are equal, fractions and others alike.
constexpr double kEqual = 1e-11;

bool same_design(const PlainDesign& design, const Choice& choice, const Gears& g) {
  const bool same_teeth = design.gears.sun == g.sun && design.gears.first == g.first &&
                          (is_planetary(*choice.problem) || design.gears.second == g.second);
  return same_teeth && design.planet_count == choice.planet_count &&
         design.module_mm == choice.module_mm;
}

}  // namespace

long PlainBox::size() const {
  long size = 1;
  for (std::size_t i = 0; i < 3; ++i) size *= std::max(0L, upper[i] - lower[i] + 1);
  return size;
}

Choice choice_of(const PlainDesign& design, const Problem& problem) {
  return {&problem, design.planet_count, design.module_mm};
}

Gears gears_at(const PlainPoint& point) { return {point[0], point[1], point[1] - point[2]}; }

std::vector<std::string> variables(const Problem& problem) {
  if (is_planetary(problem)) return {"sun", "planet"};
  return {"sun", "planet_1", "difference"};
}

PlainBox root_box(const PlainClaim& claim, const Choice& choice) {
  double largest = number(claim.problem->rotor_inner_diameter_mm) / choice.module_mm;
  if (claim.ring_limit > 0) largest = static_cast<double>(claim.ring_limit);
  if (claim.key == "/rotor_inner_diameter_mm") {
    const Choice own = choice_of(*claim.reference, *claim.problem);
    largest = quantity(claim.quantity, own, claim.reference->gears) / choice.module_mm;
  }
  const long most = static_cast<long>(std::floor(largest + 1e-9));
  if (is_planetary(*claim.problem)) return {{1, 1, 0}, {most, most / 2, 0}};
  return {{1, 1, 1}, {most, most / 2, most / 2}};
}

int against_reference(const PlainClaim& claim, const Choice& choice, const Gears& gears) {
  const Choice own = choice_of(*claim.reference, *claim.problem);
  const double threshold = quantity(claim.quantity, own, claim.reference->gears);
  const double value = quantity(claim.quantity, choice, gears);
  if (std::abs(value - threshold) <= kEqual * std::abs(threshold)) return 0;
  return (value > threshold) == greater_is_better(claim.quantity) ? 1 : -1;
}

bool allowed(const PlainClaim& claim, const Choice& choice, const PlainPoint& point) {
  const Gears g = gears_at(point);
  if (g.second < 1) return true;
  if (claim.ring_limit > 0 && g.sun + 2 * g.first > claim.ring_limit) return true;
  const auto violated = [&](const std::string& name) { return !holds(name, choice, g); };
  if (std::any_of(claim.hypotheses.begin(), claim.hypotheses.end(), violated)) return true;
  if (claim.reference) {
    const int order = against_reference(claim, choice, g);
    if (order < 0 || (order == 0 && claim.kind == "least_relaxation")) return true;
  }
  return std::any_of(claim.listed.begin(), claim.listed.end(),
                     [&](const PlainDesign& each) { return same_design(each, choice, g); });
}

Json design_json(const PlainDesign& design, const Problem& problem) {
  const auto& [sun, first, second] = design.gears;
  Json teeth{{"sun", sun}};
  if (is_planetary(problem)) {
    teeth["planet"] = first;
    teeth["ring"] = sun + 2 * first;
  } else {
    teeth["planet_1"] = first;
    teeth["planet_2"] = second;
    teeth["fixed_ring"] = sun + 2 * first;
    teeth["output_ring"] = sun + first + second;
  }
  return {{"teeth", teeth}, {"planet_count", design.planet_count}, {"module_mm", design.module_mm}};
}

}  // namespace torquewright::gearbox::proof_test
