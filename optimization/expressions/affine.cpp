// SPDX-License-Identifier: Apache-2.0
#include "optimization/expressions/affine.hpp"

namespace torquewright::optimization {
namespace {

// A variable that does not stand in a form: rounding outward would bring it in.
bool is_absent(Interval coefficient) {
  return coefficient.lower == 0.0 && coefficient.upper == 0.0;
}

Interval coefficient_of_sum(Interval a, Interval b) {
  if (is_absent(a)) return b;
  return is_absent(b) ? a : a + b;
}

}  // namespace

Interval Affine::over(const Box& box) const {
  Interval total = constant;
  for (std::size_t i = 0; i < box.size(); ++i) {
    total = total + coefficients[i] * box[i].interval();
  }
  return total;
}

Interval Affine::at(std::span<const double> point) const {
  Interval total = constant;
  for (std::size_t i = 0; i < point.size(); ++i) {
    total = total + coefficients[i] * Interval(point[i]);
  }
  return total;
}

Affine scaled(const Affine& form, Interval factor) {
  Affine result = form;
  result.constant = form.constant * factor;
  for (Interval& coefficient : result.coefficients) {
    if (!is_absent(coefficient)) coefficient = coefficient * factor;
  }
  return result;
}

Affine sum(const Affine& a, const Affine& b) {
  Affine result = a;
  result.constant = a.constant + b.constant;
  for (std::size_t i = 0; i < result.coefficients.size(); ++i) {
    result.coefficients[i] = coefficient_of_sum(a.coefficients[i], b.coefficients[i]);
  }
  return result;
}

namespace {

std::optional<Affine> product_form(const Expression& a, const Expression& b, std::size_t count) {
  if (!a.is_constant() && !b.is_constant()) return std::nullopt;
  const Expression& factor = a.is_constant() ? a : b;
  const auto form = affine_form(a.is_constant() ? b : a, count);
  if (!form) return std::nullopt;
  return scaled(*form, factor.node().value.outward());
}

}  // namespace

std::optional<Affine> affine_form(const Expression& expression, std::size_t variable_count) {
  const ExpressionNode& node = expression.node();
  const auto form_of = [&](std::size_t i) {
    return affine_form(node.arguments[i], variable_count);
  };
  Affine form{0.0, std::vector<Interval>(variable_count, Interval(0.0))};
  switch (node.operation) {
    case Operation::kConstant:
      form.constant = node.value.outward();
      return form;
    case Operation::kVariable:
      form.coefficients[node.variable] = 1.0;
      return form;
    case Operation::kNegate: {
      const auto a = form_of(0);
      return a ? std::optional(scaled(*a, -1.0)) : std::nullopt;
    }
    case Operation::kSum:
    case Operation::kDifference: {
      const auto a = form_of(0), b = form_of(1);
      if (!a || !b) return std::nullopt;
      return sum(*a, node.operation == Operation::kSum ? *b : scaled(*b, -1.0));
    }
    case Operation::kProduct:
      return product_form(node.arguments[0], node.arguments[1], variable_count);
    case Operation::kQuotient: {
      if (!node.arguments[1].is_constant()) return std::nullopt;
      const auto a = form_of(0);
      if (!a) return std::nullopt;
      return scaled(*a, Interval(1.0) / node.arguments[1].node().value.outward());
    }
    default:
      return std::nullopt;
  }
}

}  // namespace torquewright::optimization
