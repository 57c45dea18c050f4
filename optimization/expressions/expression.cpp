// SPDX-License-Identifier: Apache-2.0
#include "optimization/expressions/expression.hpp"

#include <algorithm>
#include <stdexcept>

#include "optimization/expressions/apply.hpp"

namespace torquewright::optimization {
namespace {

const PreciseInterval& value_of_constant(const Expression& a) {
  if (!a.is_constant()) throw std::logic_error("sin, cos and tan are for constants");
  return a.node().value;
}

}  // namespace

Expression constant(const PreciseInterval& value) {
  auto node = std::make_shared<ExpressionNode>();
  node->value = value;
  return Expression(std::shared_ptr<const ExpressionNode>(std::move(node)));
}

Expression combine(Operation operation, std::vector<Expression> arguments) {
  const bool all_constant = std::all_of(arguments.begin(), arguments.end(),
                                        [](const Expression& a) { return a.is_constant(); });
  if (all_constant) {
    const PreciseInterval& first = arguments.front().node().value;
    const PreciseInterval& second = arguments.back().node().value;
    return constant(apply(operation, first, second));
  }
  auto node = std::make_shared<ExpressionNode>();
  node->operation = operation;
  node->arguments = std::move(arguments);
  return Expression(std::shared_ptr<const ExpressionNode>(std::move(node)));
}

Expression::Expression(double value) : Expression(constant(PreciseInterval(value))) {}
Expression::Expression(const io::Rational& value) : Expression(constant(PreciseInterval(value))) {}

Expression Expression::variable(std::size_t index) {
  auto node = std::make_shared<ExpressionNode>();
  node->operation = Operation::kVariable;
  node->variable = index;
  return Expression(std::shared_ptr<const ExpressionNode>(std::move(node)));
}

Expression Expression::pi() { return constant(PreciseInterval::pi()); }

Expression Expression::between(const io::Rational& lower, const io::Rational& upper) {
  return constant(PreciseInterval(PreciseInterval(lower), PreciseInterval(upper)));
}

bool Expression::is_constant() const { return node_->operation == Operation::kConstant; }

Expression operator-(const Expression& a) { return combine(Operation::kNegate, {a}); }
Expression operator+(const Expression& a, const Expression& b) {
  return combine(Operation::kSum, {a, b});
}
Expression operator-(const Expression& a, const Expression& b) {
  return combine(Operation::kDifference, {a, b});
}
Expression operator*(const Expression& a, const Expression& b) {
  return combine(Operation::kProduct, {a, b});
}
Expression operator/(const Expression& a, const Expression& b) {
  return combine(Operation::kQuotient, {a, b});
}
Expression square(const Expression& a) { return combine(Operation::kSquare, {a}); }
Expression square_over(const Expression& a, const Expression& b) {
  return combine(Operation::kSquareOver, {a, b});
}
Expression sqrt(const Expression& a) { return combine(Operation::kSquareRoot, {a}); }
Expression asin(const Expression& a) { return combine(Operation::kArcSine, {a}); }
Expression acos(const Expression& a) { return combine(Operation::kArcCosine, {a}); }
Expression atan(const Expression& a) { return combine(Operation::kArcTangent, {a}); }
Expression abs(const Expression& a) { return combine(Operation::kAbsolute, {a}); }
Expression min(const Expression& a, const Expression& b) {
  return combine(Operation::kMinimum, {a, b});
}
Expression max(const Expression& a, const Expression& b) {
  return combine(Operation::kMaximum, {a, b});
}
Expression sin(const Expression& a) { return constant(sin(value_of_constant(a))); }
Expression cos(const Expression& a) { return constant(cos(value_of_constant(a))); }
Expression tan(const Expression& a) { return constant(tan(value_of_constant(a))); }

}  // namespace torquewright::optimization
