// SPDX-License-Identifier: Apache-2.0
#include "tests/optimization/toy_problems.hpp"

#include <algorithm>

namespace torquewright::optimization {
namespace {

using Test = std::function<bool(const Point&)>;
using Value = std::function<Rational(const Point&)>;

Condition condition(const std::string& name, const Expression& body, bool strict = false) {
  return {name, name, "", body, strict};
}

Rational squared(const Rational& value) { return value * value; }

struct Body {
  Expression expression;
  Value value;
};

Body draw_linear(Dice& dice, std::size_t variables, std::int64_t steepest) {
  Rational constant(dice.between(-40, 60), dice.between(1, 3));
  constant.canonicalize();
  Body linear{Expression(constant), [constant](const Point&) { return constant; }};
  for (std::size_t i = 0; i < variables; ++i) {
    const std::int64_t slope = dice.between(-steepest, steepest);
    if (slope == 0) continue;
    linear.expression = linear.expression + static_cast<double>(slope) * Expression::variable(i);
    linear.value = [before = linear.value, slope, i](const Point& point) -> Rational {
      return before(point) + slope * Rational(point[i]);
    };
  }
  return linear;
}

/// At least 1 wherever no variable is below `least`.
Body draw_positive(Dice& dice, std::size_t variables, std::int64_t least) {
  const auto i =
      static_cast<std::size_t>(dice.between(0, static_cast<std::int64_t>(variables) - 1));
  const std::int64_t shift = 1 - least + dice.between(0, 3);
  return {Expression::variable(i) + static_cast<double>(shift),
          [i, shift](const Point& point) -> Rational { return Rational(point[i]) + shift; }};
}

enum Kind { kLinear, kInside, kOutside, kOver, kBelowOver, kProduct, kKinds };

/// One random body, about as often positive as negative.
Body draw_body(Dice& dice, Kind kind, const Box& domain) {
  const std::size_t n = domain.size();
  const Body u = draw_linear(dice, n, 2), v = draw_linear(dice, n, 2);
  const Rational limit(dice.between(50, 900));
  std::int64_t least = 0;
  for (const Range& range : domain) least = std::min(least, range.lower);
  const Body d = draw_positive(dice, n, least);
  switch (kind) {
    case kLinear:
      return draw_linear(dice, n, 4);
    case kInside:
      return {Expression(limit) - square(u.expression) - square(v.expression),
              [=](const Point& p) -> Rational {
                return limit - squared(u.value(p)) - squared(v.value(p));
              }};
    case kOutside:
      return {square(u.expression) + 0.5 * square(v.expression) - Expression(limit),
              [=](const Point& p) -> Rational {
                return squared(u.value(p)) + squared(v.value(p)) / 2 - limit;
              }};
    case kOver:
      return {v.expression + 40.0 - square_over(u.expression, d.expression),
              [=](const Point& p) -> Rational {
                return v.value(p) + 40 - squared(u.value(p)) / d.value(p);
              }};
    case kBelowOver:
      return {square_over(u.expression, d.expression) - v.expression,
              [=](const Point& p) -> Rational {
                return squared(u.value(p)) / d.value(p) - v.value(p);
              }};
    default:
      return {Expression(limit) - u.expression * v.expression,
              [=](const Point& p) -> Rational { return limit - u.value(p) * v.value(p); }};
  }
}

/// A random problem in the making, in both of its forms.
class Draft {
 public:
  Draft(Dice& dice, std::size_t variables, std::int64_t narrowest, std::int64_t widest)
      : dice_(dice) {
    for (std::size_t i = 0; i < variables; ++i) {
      const std::int64_t lower = dice.between(-9, 9);
      problem_.variables.push_back(std::string(1, static_cast<char>('x' + i)));
      problem_.domain.push_back({lower, lower + dice.between(narrowest, widest)});
    }
  }

  void add_condition(Kind kind) {
    const Body body = draw_body(dice_, kind, problem_.domain);
    const bool strict = dice_.chance(30);
    problem_.conditions.push_back(
        condition("c" + std::to_string(tests_.size()), body.expression, strict));
    problem_.conditions.back().on_boxes = !dice_.chance(10);
    tests_.push_back(
        [=](const Point& p) { return strict ? body.value(p) > 0 : body.value(p) >= 0; });
  }

  void add_divisibility() {
    const std::int64_t divisor = dice_.between(2, 4);
    problem_.predicates.push_back({"divisible", "", [divisor](std::span<const std::int64_t> p) {
                                     return (p[0] + 2 * p[1]) % divisor == 0;
                                   }});
    tests_.push_back([divisor](const Point& p) { return (p[0] + 2 * p[1]) % divisor == 0; });
  }

  void set_goal(Kind kind, bool maximise) {
    goal_ = draw_body(dice_, kind, problem_.domain);
    problem_.goal = {"cost", "", goal_.expression, maximise, true};
  }

  /// Intervals know little of it, as every variable is in every square.
  void set_goal_of_three_squares() {
    goal_ = {Expression(0.0), [](const Point&) -> Rational { return 0; }};
    for (int i = 0; i < 3; ++i) {
      const Body u = draw_linear(dice_, problem_.domain.size(), 3);
      goal_.expression = goal_.expression + square(u.expression);
      goal_.value = [before = goal_.value, u](const Point& p) -> Rational {
        return before(p) + squared(u.value(p));
      };
    }
    problem_.goal = {"squares", "", goal_.expression, false, true};
  }

  void take_root_of_goal() {
    goal_ = {square(goal_.expression) + 1.0,
             [before = goal_.value](const Point& p) -> Rational { return squared(before(p)) + 1; }};
    problem_.goal.value = sqrt(goal_.expression);
    problem_.goal.exact = false;
  }

  Toy take(const std::string& name) const {
    const Rational sign = problem_.goal.maximise ? -1 : 1;
    return {name, problem_,
            [tests = tests_](const Point& p) {
              return std::all_of(tests.begin(), tests.end(),
                                 [&](const Test& test) { return test(p); });
            },
            [sign, value = goal_.value](const Point& p) -> Rational { return sign * value(p); }};
  }

 private:
  Dice& dice_;
  Problem problem_{{}, {}, {}, {}, {"cost", "", Expression(0.0), false, true}};
  std::vector<Test> tests_;
  Body goal_{0.0, {}};
};

}  // namespace

bool lies_in(const Point& point, const Box& box) {
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (!box[i].contains(point[i])) return false;
  }
  return true;
}

Toy knapsack() {
  const Expression c = Expression::variable(2), d = Expression::variable(3);
  return {"knapsack",
          {{"a", "b", "c", "d"},
           Box(4, Range{0, 1}),
           {condition("weight", 14.0 - 5.0 * kX - 7.0 * kY - 4.0 * c - 3.0 * d)},
           {},
           {"value", "", 8.0 * kX + 11.0 * kY + 6.0 * c + 4.0 * d, true, true}},
          [](const Point& p) { return 5 * p[0] + 7 * p[1] + 4 * p[2] + 3 * p[3] <= 14; },
          [](const Point& p) -> Rational {
            return -Rational(8 * p[0] + 11 * p[1] + 6 * p[2] + 4 * p[3]);
          }};
}

Toy whole_points_of_a_circle() {
  const Expression radius = square(kX) + square(kY);
  return {"circle",
          {{"x", "y"},
           {{-50, 50}, {-50, 50}},
           {condition("inside", 25.0 - radius), condition("outside", radius - 25.0)},
           {},
           {"distance", "", square(kX - 3.0) + square(kY + 2.0), false, true}},
          [](const Point& p) { return p[0] * p[0] + p[1] * p[1] == 25; },
          [](const Point& p) -> Rational {
            return squared(Rational(p[0] - 3)) + squared(Rational(p[1] + 2));
          }};
}

Toy square_over_linear() {
  return {"square over linear",
          {{"x", "y"},
           {{1, 100}, {1, 100}},
           {condition("least", kX - 10.0), condition("area", 500.0 - kX * kY)},
           {},
           {"cost", "", square_over(kX, kY) + kY, false, true}},
          [](const Point& p) { return p[0] >= 10 && p[0] * p[1] <= 500; },
          [](const Point& p) -> Rational {
            return squared(Rational(p[0])) / Rational(p[1]) + Rational(p[1]);
          }};
}

Toy without_solution() {
  const Expression difference = 6.0 * kX - 15.0 * kY - 1.0;
  return {"without solution",
          {{"x", "y"},
           {{0, 200}, {0, 200}},
           {condition("at_least", difference), condition("at_most", -difference)},
           {},
           {"sum", "", kX + kY, false, true}},
          [](const Point& p) { return 6 * p[0] == 15 * p[1] + 1; },
          [](const Point& p) -> Rational { return Rational(p[0] + p[1]); }};
}

Toy with_ties() {
  return {
      "ties",
      {{"x", "y"}, {{0, 10}, {0, 10}}, {}, {}, {"cost", "", square(kX + kY - 10.0), false, true}},
      [](const Point&) { return true; },
      [](const Point& p) -> Rational { return squared(Rational(p[0] + p[1] - 10)); }};
}

Toy random_toy(Dice& dice, std::int64_t widest) {
  Draft draft(dice, dice.chance(50) ? 3 : 2, 1, widest);
  for (std::int64_t count = dice.between(1, 3); count > 0; --count) {
    draft.add_condition(static_cast<Kind>(dice.between(0, kKinds - 1)));
  }
  if (dice.chance(30)) draft.add_divisibility();
  draft.set_goal(static_cast<Kind>(dice.between(0, kKinds - 1)), dice.chance(40));
  if (dice.chance(25)) draft.take_root_of_goal();
  return draft.take("random");
}

Toy convex_toy(Dice& dice, std::int64_t widest) {
  Draft draft(dice, 3, widest - 4, widest);
  for (std::int64_t count = dice.between(0, 2); count > 0; --count) draft.add_condition(kLinear);
  draft.set_goal_of_three_squares();
  return draft.take("convex");
}

std::vector<Point> all_points(const Box& box) {
  std::vector<Point> points{{}};
  for (const Range& range : box) {
    std::vector<Point> longer;
    for (const Point& point : points) {
      for (std::int64_t value = range.lower; value <= range.upper; ++value) {
        longer.push_back(point);
        longer.back().push_back(value);
      }
    }
    points = std::move(longer);
  }
  return points;
}

std::vector<Point> brute_force(const Toy& toy) {
  std::vector<std::pair<Rational, Point>> found;
  for (Point& point : all_points(toy.problem.domain)) {
    if (toy.is_feasible(point)) found.emplace_back(toy.cost(point), std::move(point));
  }
  std::sort(found.begin(), found.end());
  std::vector<Point> points;
  for (auto& [cost, point] : found) points.push_back(std::move(point));
  return points;
}

}  // namespace torquewright::optimization
