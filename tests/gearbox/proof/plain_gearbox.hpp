// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "gearbox/problem.hpp"

namespace torquewright::gearbox::proof_test {

inline constexpr double kPi = std::numbers::pi;

/// One way to choose planets and module, in plain doubles.
struct Choice {
  const Problem* problem;
  long planet_count;
  double module_mm;
};

/// sun, planet_1, planet_2; planetary: sun, planet, and the planet again.
struct Gears {
  long sun, first, second;
};

/// The oracle of these tests: the tables of docs/gearbox_constraints.md typed in doubles, once more
/// and as naively as possible. Limits are compared with 1e-9 of slack, which no tooth count meets
/// but by equality.
/// Teeth of a ring into which the stated shaper can be fed.
long fewest_fed(const Problem& problem);

bool holds(const std::string& constraint, const Choice& choice, const Gears& gears);
std::vector<std::string> constraint_names(const Problem& problem);

/// By the name that claims use.
double quantity(const std::string& name, const Choice& choice, const Gears& gears);
bool greater_is_better(const std::string& quantity_name);

double ratio(const Choice& choice, const Gears& gears);
double contact_ratio(int mesh, const Gears& gears);

bool is_planetary(const Problem& problem);
std::string objective_name(const Problem& problem);
double number(const Rational& value);

}  // namespace torquewright::gearbox::proof_test
