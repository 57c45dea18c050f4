// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "tests/optimization/nonlinear/hock_schittkowski/powers.hpp"
#include "tests/optimization/nonlinear/hock_schittkowski/published_problem.hpp"

namespace torquewright::optimization {
namespace {

constexpr auto kSumOfSquares = [](auto x) { return square(x(1)) + square(x(2)); };

/// x* of HS11.
std::vector<double> nearest_on_the_parabola() {
  const double a = 7.5 * std::sqrt(6.0) + std::sqrt(338.5);
  const double c = std::cbrt(a);
  return {(c - 1.0 / c) / std::sqrt(6.0), (c * c - 2.0 + 1.0 / (c * c)) / 6.0};
}

std::vector<PublishedProblem> without_bounds() {
  const double root7 = std::sqrt(7.0);
  return {
      hs(10, {-10.0, 10.0}, all(2, kFree))
          .minimise([](auto x) { return x(1) - x(2); })
          .subject_to({kNotNegative},
                      [](auto x) {
                        return list(-3.0 * square(x(1)) + 2.0 * x(1) * x(2) - square(x(2)) + 1.0);
                      })
          .has(-1.0, {0.0, 1.0}),
      hs(11, {4.9, 0.1}, all(2, kFree))
          .minimise([](auto x) { return square(x(1) - 5.0) + square(x(2)) - 25.0; })
          .subject_to({kNotNegative}, [](auto x) { return list(x(2) - square(x(1))); })
          .has(-8.498464223, nearest_on_the_parabola()),
      hs(12, {0.0, 0.0}, all(2, kFree))
          .minimise([](auto x) {
            return 0.5 * square(x(1)) + square(x(2)) - x(1) * x(2) - 7.0 * (x(1) + x(2));
          })
          .subject_to({kNotNegative},
                      [](auto x) { return list(25.0 - 4.0 * square(x(1)) - square(x(2))); })
          .has(-30.0, {2.0, 3.0}),
      hs(14, {2.0, 2.0}, all(2, kFree))
          .minimise([](auto x) { return square(x(1) - 2.0) + square(x(2) - 1.0); })
          .subject_to({kNotNegative, kZero},
                      [](auto x) {
                        return list(1.0 - 0.25 * square(x(1)) - square(x(2)),
                                    x(1) - 2.0 * x(2) + 1.0);
                      })
          .has(9.0 - 2.875 * root7, {0.5 * (root7 - 1.0), 0.25 * (root7 + 1.0)}),
      hs(22, {2.0, 2.0}, all(2, kFree))
          .minimise([](auto x) { return square(x(1) - 2.0) + square(x(2) - 1.0); })
          .subject_to({kNotNegative, kNotNegative},
                      [](auto x) { return list(2.0 - x(1) - x(2), x(2) - square(x(1))); })
          .has(1.0, {1.0, 1.0}),
  };
}

/// Rosenbrock's function over regions with several local optima; those that are found lie where
/// x1 = -1/2 meets the first row's bound (HS16) or the third's (HS20).
std::vector<PublishedProblem> in_the_valley() {
  return {
      hs(15, {-2.0, 1.0}, {{-kInfinity, 0.5}, kFree})
          .minimise(kRosenbrock)
          .subject_to({kNotNegative, kNotNegative},
                      [](auto x) { return list(x(1) * x(2) - 1.0, x(1) + square(x(2))); })
          .has(306.5, {0.5, 2.0}),
      hs(16, {-2.0, 1.0}, {{-0.5, 0.5}, {-kInfinity, 1.0}})
          .minimise(kRosenbrock)
          .subject_to({kNotNegative, kNotNegative},
                      [](auto x) { return list(x(1) + square(x(2)), square(x(1)) + x(2)); })
          .has(0.25, {0.5, 0.25})
          .ending_at(2.25 + 100.0 * square(std::sqrt(0.5) - 0.25)),
      hs(17, {-2.0, 1.0}, {{-0.5, 0.5}, {-kInfinity, 1.0}})
          .minimise(kRosenbrock)
          .subject_to({kNotNegative, kNotNegative},
                      [](auto x) { return list(square(x(2)) - x(1), square(x(1)) - x(2)); })
          .has(1.0, {0.0, 0.0})
          .flat_to(1e-4),
      hs(20, {-2.0, 1.0}, {{-0.5, 0.5}, kFree})
          .minimise(kRosenbrock)
          .subject_to(all(3, kNotNegative),
                      [](auto x) {
                        return list(x(1) + square(x(2)), square(x(1)) + x(2),
                                    square(x(1)) + square(x(2)) - 1.0);
                      })
          .has(81.5 - 25.0 * kRoot3, {0.5, 0.5 * kRoot3})
          .ending_at(83.5 - 25.0 * kRoot3),
  };
}

std::vector<PublishedProblem> with_bounds() {
  return {
      // No constraint qualification: the region ends in a cusp, and multipliers do not exist.
      hs(13, {-2.0, -2.0}, all(2, kNotNegative))
          .minimise([](auto x) { return square(x(1) - 2.0) + square(x(2)); })
          .subject_to({kNotNegative}, [](auto x) { return list(cube(1.0 - x(1)) - x(2)); })
          .has(1.0, {1.0, 0.0})
          .flat_to(1e-4),
      hs(18, {2.0, 2.0}, {{2, 50}, {0, 50}})
          .minimise([](auto x) { return 0.01 * square(x(1)) + square(x(2)); })
          .subject_to(
              {kNotNegative, kNotNegative},
              [](auto x) { return list(x(1) * x(2) - 25.0, square(x(1)) + square(x(2)) - 25.0); })
          .has(5.0, {std::sqrt(250.0), std::sqrt(2.5)}),
      // A sliver between two circles.
      hs(19, {20.1, 5.84}, {{13, 100}, {0, 100}})
          .minimise([](auto x) { return cube(x(1) - 10.0) + cube(x(2) - 20.0); })
          .subject_to({kNotNegative, kNotNegative},
                      [](auto x) {
                        return list(square(x(1) - 5.0) + square(x(2) - 5.0) - 100.0,
                                    82.81 - square(x(2) - 5.0) - square(x(1) - 6.0));
                      })
          .has(-6961.81381, {14.095, 0.84296079}),
      hs(21, {-1.0, -1.0}, {{2, 50}, {-50, 50}})
          .minimise([](auto x) { return 0.01 * square(x(1)) + square(x(2)) - 100.0; })
          .subject_to({kNotNegative}, [](auto x) { return list(10.0 * x(1) - x(2) - 10.0); })
          .has(-99.96, {2.0, 0.0}),
      hs(23, {3.0, 1.0}, all(2, {-50.0, 50.0}))
          .minimise(kSumOfSquares)
          .subject_to(all(5, kNotNegative),
                      [](auto x) {
                        return list(x(1) + x(2) - 1.0, square(x(1)) + square(x(2)) - 1.0,
                                    9.0 * square(x(1)) + square(x(2)) - 9.0, square(x(1)) - x(2),
                                    square(x(2)) - x(1));
                      })
          .has(2.0, {1.0, 1.0}),
      hs(24, {1.0, 0.5}, all(2, kNotNegative))
          .minimise(
              [](auto x) { return (square(x(1) - 3.0) - 9.0) * cube(x(2)) / (27.0 * kRoot3); })
          .subject_to(all(3, kNotNegative),
                      [](auto x) {
                        return list(x(1) / kRoot3 - x(2), x(1) + kRoot3 * x(2),
                                    6.0 - x(1) - kRoot3 * x(2));
                      })
          .has(-1.0, {3.0, kRoot3}),
  };
}

}  // namespace

std::vector<PublishedProblem> problems_in_the_plane() {
  std::vector<PublishedProblem> problems;
  for (auto part : {without_bounds, in_the_valley, with_bounds}) {
    for (PublishedProblem& problem : part()) problems.push_back(std::move(problem));
  }
  return problems;
}

}  // namespace torquewright::optimization
