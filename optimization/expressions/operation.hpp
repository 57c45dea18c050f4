// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::optimization {

/// Kind of a node of an expression: a number, a variable, or an operation on one or two arguments.
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
