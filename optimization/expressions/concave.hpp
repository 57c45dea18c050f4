// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "optimization/expressions/affine.hpp"
#include "optimization/expressions/box.hpp"
#include "optimization/expressions/expression.hpp"

namespace torquewright::optimization {

/// weight u^2, or weight u^2/v where v is given (v > 0 on the box); weight >= 0: convex.
struct SquareTerm {
  Interval weight;
  Affine u;
  std::optional<Affine> v;
};

/// affine - sum of squares: a concave function of the variables.
struct ConcaveForm {
  Affine affine;
  std::vector<SquareTerm> squares;
};

/// A concave function that is nowhere below the expression on the box. Linear parts and squares
/// with the right sign are kept as they are; squares with the other sign become their chord (for
/// u^2/v: the chord of r^2 over the cone of ratios r = u/v in the box); any other part is replaced
/// by its greatest value on the box. docs/certificate.md, "Relaxation leaves".
ConcaveForm concave_above(const Expression& expression, const Box& box);

struct ValueAndSlope {
  Interval value;
  std::vector<Interval> slope;
};

/// Value and gradient at a point, enclosed.
ValueAndSlope evaluate(const ConcaveForm& form, std::span<const double> point);

}  // namespace torquewright::optimization
