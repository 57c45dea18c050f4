// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "optimization/expressions/affine.hpp"
#include "optimization/expressions/box.hpp"
#include "optimization/expressions/expression.hpp"

namespace torquewright::optimization {

/// A convex term: weight u^2, or weight u^2/v where v is given (v > 0 on the box); weight >= 0.
struct SquareTerm {
  Interval weight;
  Affine u;
  std::optional<Affine> v;
};

/// A concave function of the variables: affine - sum of squares.
struct ConcaveForm {
  Affine affine;
  std::vector<SquareTerm> squares;
};

/// Returns a concave function that is nowhere below the expression on the box. Linear parts and
/// squares with the right sign are kept; squares with the other sign become their chord (for u^2/v:
/// the chord of r^2 over the cone of ratios r = u/v in the box); any other part is replaced by its
/// greatest value on the box. docs/certificate.md, "Relaxation leaves".
ConcaveForm concave_above(const Expression& expression, const Box& box);

struct ValueAndSlope {
  Interval value;
  std::vector<Interval> slope;
};

/// Returns enclosed value and gradient at a point.
ValueAndSlope evaluate(const ConcaveForm& form, std::span<const double> point);

}  // namespace torquewright::optimization
