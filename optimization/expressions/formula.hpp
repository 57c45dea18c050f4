// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "optimization/expressions/expression.hpp"

namespace torquewright::optimization {

/// An expression prepared for evaluation: its nodes in an order in which arguments come first.
class Formula {
 public:
  explicit Formula(const Expression& expression);

  /// Encloses the expression's values over a box.
  Interval over(std::span<const Interval> box) const;
  /// Encloses its value at a point, in doubles and in 256 bits.
  Interval at(std::span<const std::int64_t> point) const;
  PreciseInterval precisely_at(std::span<const std::int64_t> point) const;

 private:
  struct Step {
    Operation operation;
    std::size_t first;   ///< Index of the step of the first argument; of kVariable the variable's.
    std::size_t second;  ///< Index of the step of the last argument.
    std::size_t constant;
  };
  template <class Number, class Variable, class Constant>
  Number evaluate(std::vector<Number>& storage, Variable variable, Constant constant) const;

  std::vector<Step> steps_;
  std::vector<Interval> constants_;
  std::vector<PreciseInterval> precise_constants_;
};

}  // namespace torquewright::optimization
