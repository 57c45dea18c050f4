// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "tests/optimization/nonlinear/hock_schittkowski/powers.hpp"
#include "tests/optimization/nonlinear/hock_schittkowski/published_problem.hpp"

namespace torquewright::optimization {
namespace {

/// Where Rosenbrock's function is stationary along x2 = 1.5: a root of 400 x^3 - 598 x - 2, of
/// which there are three (0, 1, 2).
double root_of_hs2(int which) {
  const double a = std::sqrt(598.0 / 1200.0);
  const double b = 400.0 * a * a * a;
  return 2.0 * a * std::cos((std::acos(1.0 / b) + 2.0 * std::numbers::pi * which) / 3.0);
}

/// The root that is a minimum and not the least one.
double other_optimum_of_hs2() {
  const double x = root_of_hs2(1);
  return 100.0 * (1.5 - x * x) * (1.5 - x * x) + (1.0 - x) * (1.0 - x);
}

/// Colville's fourth.
constexpr auto kWood = [](auto x) {
  return 100.0 * square(x(2) - square(x(1))) + square(1.0 - x(1)) +
         90.0 * square(x(4) - square(x(3))) + square(1.0 - x(3)) +
         10.1 * (square(x(2) - 1.0) + square(x(4) - 1.0)) + 19.8 * (x(2) - 1.0) * (x(4) - 1.0);
};

constexpr auto kTenLogarithms = [](auto x) {
  typename decltype(x)::Kind sum(0.0), product(1.0);
  for (std::size_t i = 1; i <= 10; ++i) {
    sum += square(logarithm(x(i) - 2.0)) + square(logarithm(10.0 - x(i)));
    product = product * x(i);
  }
  return sum - power(product, 0.2);
};

}  // namespace

std::vector<PublishedProblem> problems_with_bounds() {
  using std::numbers::pi;
  return {
      hs(1, {-2.0, 1.0}, {kFree, {-1.5, kInfinity}}).minimise(kRosenbrock).has(0.0, {1.0, 1.0}),
      hs(2, {-2.0, 1.0}, {kFree, {1.5, kInfinity}})
          .minimise(kRosenbrock)
          .has(0.0504261879, {root_of_hs2(0), 1.5})
          .ending_at(other_optimum_of_hs2()),
      hs(3, {10.0, 1.0}, {kFree, kNotNegative})
          .minimise([](auto x) { return x(2) + 1e-5 * square(x(2) - x(1)); })
          .has(0.0, {0.0, 0.0}),
      hs(4, {1.125, 0.125}, {{1.0, kInfinity}, kNotNegative})
          .minimise([](auto x) { return cube(x(1) + 1.0) / 3.0 + x(2); })
          .has(8.0 / 3.0, {1.0, 0.0}),
      hs(5, {0.0, 0.0}, {{-1.5, 4.0}, {-3.0, 3.0}})
          .minimise([](auto x) {
            using std::sin;
            return sin(x(1) + x(2)) + square(x(1) - x(2)) - 1.5 * x(1) + 2.5 * x(2) + 1.0;
          })
          .has(-std::sqrt(3.0) / 2.0 - pi / 3.0, {-pi / 3.0 + 0.5, -pi / 3.0 - 0.5}),
      hs(38, {-3.0, -1.0, -3.0, -1.0}, all(4, {-10.0, 10.0}))
          .minimise(kWood)
          .has(0.0, {1.0, 1.0, 1.0, 1.0}),
      hs(45, {2.0, 2.0, 2.0, 2.0, 2.0}, {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}})
          .minimise([](auto x) { return 2.0 - x(1) * x(2) * x(3) * x(4) * x(5) / 120.0; })
          .has(1.0, {1.0, 2.0, 3.0, 4.0, 5.0}),
      hs(110, std::vector<double>(10, 9.0), all(10, {2.001, 9.999}))
          .minimise(kTenLogarithms)
          .has(-45.77846971, std::vector<double>(10, 9.35026583)),
  };
}

}  // namespace torquewright::optimization
