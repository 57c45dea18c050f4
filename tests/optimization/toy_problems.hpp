// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "optimization/discrete/problem.hpp"
#include "tests/optimization/true_values.hpp"
#include "tests/oracles/dice.hpp"

namespace torquewright::optimization {

using oracles::Dice;
using Point = std::vector<std::int64_t>;

/// The first two variables.
inline const Expression kX = Expression::variable(0);
inline const Expression kY = Expression::variable(1);

/// A problem that has nothing to do with gears, stated twice: for the search, and in exact
/// fractions, which share no code with it.
struct Toy {
  std::string name;
  Problem problem;
  std::function<bool(const Point&)> is_feasible;
  /// Less is better. For goals that are roots: the number under the root, which has the same order.
  std::function<Rational(const Point&)> cost;
};

/// max 8 a + 11 b + 6 c + 4 d subject to 5 a + 7 b + 4 c + 3 d <= 14, each 0 or 1: 21 at (0,1,1,1).
Toy knapsack();
/// min (x - 3)^2 + (y + 2)^2 on whole points of the circle x^2 + y^2 = 25: 2 at (4, -3).
Toy whole_points_of_a_circle();
/// min x^2/y + y with x >= 10, x y <= 500, in 1..100: convex goal, nonconvex condition; 20 at (10,
/// 10).
Toy square_over_linear();
/// 6 x = 15 y + 1 has no solution in whole numbers, but plenty in reals.
Toy without_solution();
/// min (x + y - 10)^2, x and y in 0..10: eleven ties.
Toy with_ties();

/// Two or three variables, a few linear, convex, concave and nonconvex conditions, perhaps
/// divisibility, one of several goals.
Toy random_toy(Dice& dice, std::int64_t widest);
/// Three variables, linear conditions, a sum of squares to be minimised: what relaxations are good
/// at.
Toy convex_toy(Dice& dice, std::int64_t widest);

bool lies_in(const Point& point, const Box& box);
/// Every whole point of the box, by nested counting.
std::vector<Point> all_points(const Box& box);
/// Those of the domain that satisfy everything, cheapest first, then in the order of values.
std::vector<Point> brute_force(const Toy& toy);

}  // namespace torquewright::optimization
