// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::optimization {

/// What a node of an expression is: a number, a variable, or what is done to one or two arguments.
enum class Operation {
  kConstant,
  kVariable,
  kNegate,
  kSum,
  kDifference,
  kProduct,
  kQuotient,
  kSquare,
  kSquareOver,
  kSquareRoot,
  kArcSine,
  kArcCosine,
  kArcTangent,
  kAbsolute,
  kMinimum,
  kMaximum,
};

}  // namespace torquewright::optimization
