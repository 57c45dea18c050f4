// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "optimization/expressions/box.hpp"
#include "optimization/expressions/expression.hpp"

namespace torquewright::optimization {

/// An affine form: constant + sum coefficients[i] x_i, with enclosed numbers.
struct Affine {
  Interval constant = 0.0;
  std::vector<Interval> coefficients;  ///< Coefficients, one for each variable.

  Interval over(const Box& box) const;
  Interval at(std::span<const double> point) const;
};

/// Returns the expression as an affine form of `variable_count` variables, if it is built as one.
std::optional<Affine> affine_form(const Expression& expression, std::size_t variable_count);

Affine scaled(const Affine& form, Interval factor);
Affine sum(const Affine& a, const Affine& b);

}  // namespace torquewright::optimization
