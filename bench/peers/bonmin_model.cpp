// SPDX-License-Identifier: Apache-2.0
#include "bench/peers/bonmin_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace torquewright::bench {
namespace {

constexpr double kUnlimited = 1e50;

// The teeth as linear forms of the variables, so that both formulations share one text.
struct Forms {
  std::size_t size;
  std::vector<double> sun, planet_1, planet_2, fixed_ring, output_ring, multiple;
};

std::vector<double> unit(std::size_t size, std::size_t index) {
  std::vector<double> form(size, 0.0);
  form[index] = 1;
  return form;
}

std::vector<double> sum(const std::vector<double>& a, double factor, const std::vector<double>& b) {
  std::vector<double> result = a;
  for (std::size_t i = 0; i < a.size(); ++i) result[i] += factor * b[i];
  return result;
}

Forms forms(Formulation formulation) {
  if (formulation == Formulation::kRingsKept) {
    return {6, unit(6, 0), unit(6, 1), unit(6, 2), unit(6, 3), unit(6, 4), unit(6, 5)};
  }
  const auto s = unit(4, 0), p1 = unit(4, 1), p2 = unit(4, 2);
  return {4, s, p1, p2, sum(s, 2, p1), sum(sum(s, 1, p1), 1, p2), unit(4, 3)};
}

Quadratic linear(const std::vector<double>& form) { return {0, form, {}}; }

void add_product(Quadratic& to, double factor, const std::vector<double>& a,
                 const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (a[i] * b[j] != 0) to.terms.push_back({i, j, factor * a[i] * b[j]});
    }
  }
}

// 2 P1 O - G S (P1 - P2)
Quadratic ratio_row(const Forms& f, double ratio) {
  Quadratic row{0, std::vector<double>(f.size, 0.0), {}};
  add_product(row, 2, f.planet_1, f.output_ring);
  add_product(row, -ratio, f.sun, sum(f.planet_1, -1, f.planet_2));
  return row;
}

void add_ratio(const gearbox::Problem& problem, const Forms& f, IntegerProgram& program) {
  const double ratio = problem.target_ratio.get_d();
  const double tolerance = problem.ratio_tolerance.get_d();
  if (tolerance == 0) {
    program.rows.push_back({ratio_row(f, ratio), 0, 0});
    return;
  }
  program.rows.push_back({ratio_row(f, ratio * (1 - tolerance)), 0, kUnlimited});
  program.rows.push_back({ratio_row(f, ratio * (1 + tolerance)), -kUnlimited, 0});
}

void add_linear_rows(const gearbox::Problem& problem, Formulation formulation, const Forms& f,
                     double bore, IntegerProgram& program) {
  const double n = static_cast<double>(problem.planet_count.at(0));
  const double sine = std::sin(std::numbers::pi / n - problem.min_carrier_clearance_rad.get_d());
  const auto row = [&program](const std::vector<double>& form, double least, double greatest) {
    program.rows.push_back({linear(form), least, greatest});
  };
  if (formulation == Formulation::kRingsKept) {
    row(sum(sum(f.fixed_ring, -1, f.sun), -2, f.planet_1), 0, 0);
    row(sum(sum(sum(f.output_ring, -1, f.sun), -1, f.planet_1), -1, f.planet_2), 0, 0);
  } else {
    row(f.fixed_ring, -kUnlimited, bore);
  }
  row(sum(sum(f.sun, 1, f.fixed_ring), -n, f.multiple), 0, 0);
  row(sum(f.planet_1, -1, f.planet_2), n, kUnlimited);
  // pi/n - asin(P1/(S + P1)) >= alpha_min
  row(sum(sum(f.sun, sine - 1, f.sun), sine - 1, f.planet_1), 0, kUnlimited);  // s S - (1 - s) P1
}

void set_bounds(const gearbox::Problem& problem, Formulation formulation, double bore,
                IntegerProgram& program) {
  const auto least = [&problem](const char* gear) {
    return static_cast<double>(problem.min_teeth.at(gear));
  };
  const double n = static_cast<double>(problem.planet_count.at(0));
  const double most = std::floor(bore);
  program.least = {least("sun"), least("planet_1"), least("planet_2")};
  program.greatest = {most, most / 2, most / 2};
  if (formulation == Formulation::kRingsKept) {
    program.least.insert(program.least.end(), {1, 1});
    program.greatest.insert(program.greatest.end(), {most, most});
  }
  program.least.push_back(1);
  program.greatest.push_back(2 * most / n);
}

}  // namespace

IntegerProgram formulate(const gearbox::Problem& problem, Formulation formulation) {
  const Forms f = forms(formulation);
  const gearbox::Rational exact_bore = problem.rotor_inner_diameter_mm / problem.module_mm.at(0);
  const double bore = exact_bore.get_d();
  IntegerProgram program;
  set_bounds(problem, formulation, bore, program);
  program.objective = {bore * bore, std::vector<double>(f.size, 0.0), {}};
  program.objective.linear = sum(program.objective.linear, -2 * bore, f.fixed_ring);
  for (const auto* form : {&f.fixed_ring, &f.planet_1, &f.planet_2, &f.output_ring}) {
    add_product(program.objective, 1, *form, *form);
  }
  add_ratio(problem, f, program);
  add_linear_rows(problem, formulation, f, bore, program);
  return program;
}

double value(const Quadratic& form, const double* x) {
  double sum_of_terms = form.constant;
  for (std::size_t i = 0; i < form.linear.size(); ++i) sum_of_terms += form.linear[i] * x[i];
  for (const auto& [i, j, factor] : form.terms) sum_of_terms += factor * x[i] * x[j];
  return sum_of_terms;
}

void add_gradient(const Quadratic& form, const double* x, double* gradient) {
  for (std::size_t i = 0; i < form.linear.size(); ++i) gradient[i] += form.linear[i];
  for (const auto& [i, j, factor] : form.terms) {
    gradient[i] += factor * x[j];
    gradient[j] += factor * x[i];
  }
}

void add_hessian(const Quadratic& form, double weight, double* values) {
  for (const auto& [i, j, factor] : form.terms) {
    const std::size_t high = std::max(i, j), low = std::min(i, j);
    values[high * (high + 1) / 2 + low] += weight * factor * (i == j ? 2 : 1);
  }
}

}  // namespace torquewright::bench
