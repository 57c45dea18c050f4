// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

#include "optimization/expressions/operation.hpp"

namespace torquewright::optimization {

/// Applies one operation to numbers of any kind that has the functions (Interval, PreciseInterval).
/// Operations of one argument ignore the second.
template <class Number>
Number apply(Operation operation, const Number& a, const Number& b) {
  switch (operation) {
    case Operation::kNegate:
      return -a;
    case Operation::kSum:
      return a + b;
    case Operation::kDifference:
      return a - b;
    case Operation::kProduct:
      return a * b;
    case Operation::kQuotient:
      return a / b;
    case Operation::kSquare:
      return square(a);
    case Operation::kSquareOver:
      return square_over(a, b);
    case Operation::kSquareRoot:
      return sqrt(a);
    case Operation::kArcSine:
      return asin(a);
    case Operation::kArcCosine:
      return acos(a);
    case Operation::kArcTangent:
      return atan(a);
    case Operation::kAbsolute:
      return abs(a);
    case Operation::kMinimum:
      return min(a, b);
    case Operation::kMaximum:
      return max(a, b);
    case Operation::kConstant:
    case Operation::kVariable:
      break;
  }
  throw std::logic_error("a constant or variable is no operation");
}

}  // namespace torquewright::optimization
