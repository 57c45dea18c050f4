// SPDX-License-Identifier: Apache-2.0
#include "optimization/expressions/concave.hpp"

#include <cmath>

#include "optimization/expressions/formula.hpp"

namespace torquewright::optimization {
namespace {

// Adds factor * expression to a concave form, from above.
class Builder {
 public:
  explicit Builder(const Box& box) : box_(box) {
    form_.affine = {0.0, std::vector<Interval>(box.size(), Interval(0.0))};
    for (const Range& range : box) ranges_.push_back(range.interval());
  }

  void add(const Expression& expression, Interval factor) {
    if (const auto affine = affine_form(expression, box_.size())) {
      form_.affine = sum(form_.affine, scaled(*affine, factor));
      return;
    }
    const ExpressionNode& node = expression.node();
    switch (node.operation) {
      case Operation::kNegate:
        return add(node.arguments[0], -factor);
      case Operation::kSum:
        add(node.arguments[0], factor);
        return add(node.arguments[1], factor);
      case Operation::kDifference:
        add(node.arguments[0], factor);
        return add(node.arguments[1], -factor);
      case Operation::kProduct:
        return add_product(expression, factor);
      case Operation::kSquare:
      case Operation::kSquareOver:
        return add_square(expression, factor);
      default:
        return add_greatest(expression, factor);
    }
  }

  ConcaveForm take() { return std::move(form_); }

 private:
  void add_product(const Expression& expression, Interval factor) {
    for (const std::size_t i : {0u, 1u}) {
      const Expression& a = expression.node().arguments[i];
      if (!a.is_constant()) continue;
      return add(expression.node().arguments[1 - i], factor * a.node().value.outward());
    }
    add_greatest(expression, factor);
  }

  void add_square(const Expression& expression, Interval factor) {
    const ExpressionNode& node = expression.node();
    const bool has_divisor = node.operation == Operation::kSquareOver;
    const auto u = affine_form(node.arguments[0], box_.size());
    std::optional<Affine> v;
    if (has_divisor) v = affine_form(node.arguments[1], box_.size());
    const bool usable = u && (!has_divisor || (v && v->over(box_).lower > 0.0));
    if (usable && factor.upper <= 0.0) {
      form_.squares.push_back({-factor, *u, v});
    } else if (usable && factor.lower >= 0.0) {
      add_chord(*u, v, factor);
    } else {
      add_greatest(expression, factor);
    }
  }

  // r^2 <= (a + b) r - a b for a <= r <= b; times v: u^2/v <= (a + b) u - a b v.
  void add_chord(const Affine& u, const std::optional<Affine>& v, Interval factor) {
    const Interval r = v ? u.over(box_) / v->over(box_) : u.over(box_);
    const Interval a = r.lower, b = r.upper;
    form_.affine = sum(form_.affine, scaled(u, factor * (a + b)));
    const Affine one{1.0, std::vector<Interval>(box_.size(), Interval(0.0))};
    form_.affine = sum(form_.affine, scaled(v ? *v : one, -(factor * a * b)));
  }

  void add_greatest(const Expression& expression, Interval factor) {
    const Interval range = factor * Formula(expression).over(ranges_);
    // Nothing known: the form becomes useless (+infinity), never wrong.
    const double greatest = std::isnan(range.upper) ? HUGE_VAL : range.upper;
    form_.affine.constant = form_.affine.constant + Interval(greatest);
  }

  const Box& box_;
  std::vector<Interval> ranges_;
  ConcaveForm form_;
};

}  // namespace

ConcaveForm concave_above(const Expression& expression, const Box& box) {
  Builder builder(box);
  builder.add(expression, 1.0);
  return builder.take();
}

ValueAndSlope evaluate(const ConcaveForm& form, std::span<const double> point) {
  ValueAndSlope result{form.affine.at(point), form.affine.coefficients};
  for (const SquareTerm& term : form.squares) {
    const Interval u = term.u.at(point);
    const Interval v = term.v ? term.v->at(point) : Interval(1.0);
    const Interval r = u / v;
    result.value = result.value - term.weight * square(u) / v;
    for (std::size_t i = 0; i < point.size(); ++i) {
      // d(u^2/v) = 2 r du - r^2 dv
      Interval slope = Interval(2.0) * r * term.u.coefficients[i];
      if (term.v) slope = slope - square(r) * term.v->coefficients[i];
      result.slope[i] = result.slope[i] - term.weight * slope;
    }
  }
  return result;
}

}  // namespace torquewright::optimization
