// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "gearbox/problem.hpp"

namespace torquewright::bench {

/// constant + sum linear_i x_i + sum over terms c x_i x_j.
struct Quadratic {
  struct Term {
    std::size_t i, j;
    double factor;
  };
  double constant = 0;
  std::vector<double> linear;
  std::vector<Term> terms;
};

struct BoundedRow {
  Quadratic body;
  double least;
  double greatest;
};

/// Minimise 1/x_0^2 + objective over whole x. x_0 is the sun.
struct IntegerProgram {
  std::vector<double> least, greatest;  ///< Of the variables.
  Quadratic objective;
  std::vector<BoundedRow> rows;
};

/// How the paper's problem is put to the solver; always as polynomials, the ratio as
/// 2 P1 O = G S (P1 - P2), divisibility as S + F = n k with a whole k.
enum class Formulation {
  kRingsKept,        ///< Variables S, P1, P2, F, O, k; equations (2) and (3) are rows.
  kRingsEliminated,  ///< Variables S, P1, P2, k; F = S + 2 P1 and O = S + P1 + P2 put in.
};

/// Of the problem's first planet count and first module.
IntegerProgram formulate(const gearbox::Problem& problem, Formulation formulation);

double value(const Quadratic& form, const double* x);
void add_gradient(const Quadratic& form, const double* x, double* gradient);
/// Into the lower triangle by rows, times weight.
void add_hessian(const Quadratic& form, double weight, double* values);

}  // namespace torquewright::bench
