// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "io/text/rational.hpp"
#include "optimization/expressions/operation.hpp"
#include "optimization/expressions/precise_interval.hpp"

namespace torquewright::optimization {

struct ExpressionNode;

/// A formula in the variables of a problem: an immutable, shared graph. Operations on constants are
/// carried out at once, with 256 bits.
class Expression {
 public:
  Expression(double constant);               // NOLINT: a number is an expression
  Expression(const io::Rational& constant);  // NOLINT
  static Expression variable(std::size_t index);
  static Expression pi();
  /// Makes a number of which only bounds are known; for bounding, not for values.
  static Expression between(const io::Rational& lower, const io::Rational& upper);

  const ExpressionNode& node() const { return *node_; }
  bool is_constant() const;

  friend Expression combine(Operation operation, std::vector<Expression> arguments);

 private:
  explicit Expression(std::shared_ptr<const ExpressionNode> node) : node_(std::move(node)) {}
  friend Expression constant(const PreciseInterval& value);
  std::shared_ptr<const ExpressionNode> node_;
};

struct ExpressionNode {
  Operation operation = Operation::kConstant;
  std::vector<Expression> arguments;
  std::size_t variable = 0;  ///< Index of the variable (kVariable).
  PreciseInterval value;     ///< Value of the constant (kConstant).
};

Expression constant(const PreciseInterval& value);

Expression operator-(const Expression& a);
Expression operator+(const Expression& a, const Expression& b);
Expression operator-(const Expression& a, const Expression& b);
Expression operator*(const Expression& a, const Expression& b);
Expression operator/(const Expression& a, const Expression& b);
Expression square(const Expression& a);
/// a^2 / b, b > 0: jointly convex (the perspective of the square).
Expression square_over(const Expression& a, const Expression& b);
Expression sqrt(const Expression& a);
Expression asin(const Expression& a);
Expression acos(const Expression& a);
Expression atan(const Expression& a);
Expression abs(const Expression& a);
Expression min(const Expression& a, const Expression& b);
Expression max(const Expression& a, const Expression& b);
/// The sine of an expression that holds constants only.
Expression sin(const Expression& a);
Expression cos(const Expression& a);
Expression tan(const Expression& a);

}  // namespace torquewright::optimization
