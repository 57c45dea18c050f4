// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "tests/optimization/nonlinear/hock_schittkowski/powers.hpp"
#include "tests/optimization/nonlinear/hock_schittkowski/published_problem.hpp"

namespace torquewright::optimization {
namespace {

std::vector<PublishedProblem> of_two_unknowns() {
  using std::numbers::pi;
  const double of_hs8 = std::sqrt((25.0 + std::sqrt(301.0)) / 2.0);
  return {
      hs(6, {-1.2, 1.0}, all(2, kFree))
          .minimise([](auto x) { return square(1.0 - x(1)); })
          .subject_to({kZero}, [](auto x) { return list(10.0 * (x(2) - square(x(1)))); })
          .has(0.0, {1.0, 1.0}),
      hs(7, {2.0, 2.0}, all(2, kFree))
          .minimise([](auto x) { return logarithm(1.0 + square(x(1))) - x(2); })
          .subject_to({kZero},
                      [](auto x) { return list(square(1.0 + square(x(1))) + square(x(2)) - 4.0); })
          .has(-kRoot3, {0.0, kRoot3}),
      // As many equations as unknowns.
      hs(8, {2.0, 1.0}, all(2, kFree))
          .minimise([](auto x) { return 0.0 * x(1) - 1.0; })
          .subject_to(
              {kZero, kZero},
              [](auto x) { return list(square(x(1)) + square(x(2)) - 25.0, x(1) * x(2) - 9.0); })
          .has(-1.0, {of_hs8, 9.0 / of_hs8}),
      hs(9, {0.0, 0.0}, all(2, kFree))
          .minimise([](auto x) {
            using std::cos;
            using std::sin;
            return sin(pi * x(1) / 12.0) * cos(pi * x(2) / 16.0);
          })
          .subject_to({kZero}, [](auto x) { return list(4.0 * x(1) - 3.0 * x(2)); })
          .has(-0.5, {-3.0, -4.0}),
  };
}

std::vector<PublishedProblem> of_three_or_four_unknowns() {
  return {
      // Degenerate: of fourth order about its optimum.
      hs(26, {-2.6, 2.0, 2.0}, all(3, kFree))
          .minimise([](auto x) { return square(x(1) - x(2)) + fourth(x(2) - x(3)); })
          .subject_to({kZero},
                      [](auto x) { return list((1.0 + square(x(2))) * x(1) + fourth(x(3)) - 3.0); })
          .has(0.0, {1.0, 1.0, 1.0})
          .flat_to(1e-3),
      hs(27, {2.0, 2.0, 2.0}, all(3, kFree))
          .minimise([](auto x) { return 0.01 * square(x(1) - 1.0) + square(x(2) - square(x(1))); })
          .subject_to({kZero}, [](auto x) { return list(x(1) + square(x(3)) + 1.0); })
          .has(0.04, {-1.0, 1.0, 0.0}),
      hs(28, {-4.0, 1.0, 1.0}, all(3, kFree))
          .minimise([](auto x) { return square(x(1) + x(2)) + square(x(2) + x(3)); })
          .subject_to({kZero}, [](auto x) { return list(x(1) + 2.0 * x(2) + 3.0 * x(3) - 1.0); })
          .has(0.0, {0.5, -0.5, 0.5}),
      hs(39, {2.0, 2.0, 2.0, 2.0}, all(4, kFree))
          .minimise([](auto x) { return -x(1); })
          .subject_to({kZero, kZero},
                      [](auto x) {
                        return list(x(2) - cube(x(1)) - square(x(3)),
                                    square(x(1)) - x(2) - square(x(4)));
                      })
          .has(-1.0, {1.0, 1.0, 0.0, 0.0}),
      hs(40, {0.8, 0.8, 0.8, 0.8}, all(4, kFree))
          .minimise([](auto x) { return -x(1) * x(2) * x(3) * x(4); })
          .subject_to({kZero, kZero, kZero},
                      [](auto x) {
                        return list(cube(x(1)) + square(x(2)) - 1.0, square(x(1)) * x(4) - x(3),
                                    square(x(4)) - x(2));
                      })
          .has(-0.25,
               {std::exp2(-1.0 / 3.0), std::exp2(-0.5), std::exp2(-11.0 / 12.0), std::exp2(-0.25)}),
      hs(42, {1.0, 1.0, 1.0, 1.0}, all(4, kFree))
          .minimise([](auto x) {
            return square(x(1) - 1.0) + square(x(2) - 2.0) + square(x(3) - 3.0) +
                   square(x(4) - 4.0);
          })
          .subject_to({kZero, kZero},
                      [](auto x) { return list(x(1) - 2.0, square(x(3)) + square(x(4)) - 2.0); })
          .has(28.0 - 10.0 * kRoot2, {2.0, 2.0, 0.6 * kRoot2, 0.8 * kRoot2}),
      hs(61, {0.0, 0.0, 0.0}, all(3, kFree))
          .minimise([](auto x) {
            return 4.0 * square(x(1)) + 2.0 * square(x(2)) + 2.0 * square(x(3)) - 33.0 * x(1) +
                   16.0 * x(2) - 24.0 * x(3);
          })
          .subject_to({kZero, kZero},
                      [](auto x) {
                        return list(3.0 * x(1) - 2.0 * square(x(2)) - 7.0,
                                    4.0 * x(1) - square(x(3)) - 11.0);
                      })
          .has(-143.6461422, {5.326770157, -2.118998639, 3.210464239}),
  };
}

/// Five unknowns, quadratic but for powers, linear equations.
std::vector<PublishedProblem> with_linear_equations() {
  constexpr auto miele = [](auto x) {
    return list(x(1) + 3.0 * x(2) - 4.0, x(3) + x(4) - 2.0 * x(5), x(2) - x(5));
  };
  return {
      hs(48, {3.0, 5.0, -3.0, 2.0, -2.0}, all(5, kFree))
          .minimise(
              [](auto x) { return square(x(1) - 1.0) + square(x(2) - x(3)) + square(x(4) - x(5)); })
          .subject_to({kZero, kZero},
                      [](auto x) {
                        return list(x(1) + x(2) + x(3) + x(4) + x(5) - 5.0,
                                    x(3) - 2.0 * (x(4) + x(5)) + 3.0);
                      })
          .has(0.0, {1.0, 1.0, 1.0, 1.0, 1.0}),
      hs(49, {10.0, 7.0, 2.0, -3.0, 0.8}, all(5, kFree))
          .minimise([](auto x) {
            return square(x(1) - x(2)) + square(x(3) - 1.0) + fourth(x(4) - 1.0) +
                   square(cube(x(5) - 1.0));
          })
          .subject_to({kZero, kZero},
                      [](auto x) {
                        return list(x(1) + x(2) + x(3) + 4.0 * x(4) - 7.0, x(3) + 5.0 * x(5) - 6.0);
                      })
          .has(0.0, {1.0, 1.0, 1.0, 1.0, 1.0})
          .flat_to(1e-2),
      hs(50, {35.0, -31.0, 11.0, 5.0, -5.0}, all(5, kFree))
          .minimise([](auto x) {
            return square(x(1) - x(2)) + square(x(2) - x(3)) + fourth(x(3) - x(4)) +
                   square(x(4) - x(5));
          })
          .subject_to({kZero, kZero, kZero},
                      [](auto x) {
                        return list(x(1) + 2.0 * x(2) + 3.0 * x(3) - 6.0,
                                    x(2) + 2.0 * x(3) + 3.0 * x(4) - 6.0,
                                    x(3) + 2.0 * x(4) + 3.0 * x(5) - 6.0);
                      })
          .has(0.0, {1.0, 1.0, 1.0, 1.0, 1.0}),
      hs(51, {2.5, 0.5, 2.0, -1.0, 0.5}, all(5, kFree))
          .minimise([](auto x) {
            return square(x(1) - x(2)) + square(x(2) + x(3) - 2.0) + square(x(4) - 1.0) +
                   square(x(5) - 1.0);
          })
          .subject_to({kZero, kZero, kZero}, miele)
          .has(0.0, {1.0, 1.0, 1.0, 1.0, 1.0}),
      hs(52, {2.0, 2.0, 2.0, 2.0, 2.0}, all(5, kFree))
          .minimise([](auto x) {
            return square(4.0 * x(1) - x(2)) + square(x(2) + x(3) - 2.0) + square(x(4) - 1.0) +
                   square(x(5) - 1.0);
          })
          .subject_to({{-4.0, -4.0}, kZero, kZero}, miele)
          .has(1859.0 / 349.0,
               {-33.0 / 349.0, 11.0 / 349.0, 180.0 / 349.0, -158.0 / 349.0, 11.0 / 349.0}),
  };
}

/// Five unknowns and more.
std::vector<PublishedProblem> with_curved_equations() {
  using std::sin;
  const double a = std::asin(std::sqrt(1.0 / 4.2)), b = std::asin(std::sqrt(5.0 / 7.2));
  return {hs(46, {0.5 * kRoot2, 1.75, 0.5, 2.0, 2.0}, all(5, kFree))
              .minimise([](auto x) {
                return square(x(1) - x(2)) + square(x(3) - 1.0) + fourth(x(4) - 1.0) +
                       square(cube(x(5) - 1.0));
              })
              .subject_to({{1.0, 1.0}, {2.0, 2.0}},
                          [](auto x) {
                            return list(square(x(1)) * x(4) + sin(x(4) - x(5)),
                                        x(2) + fourth(x(3)) * square(x(4)));
                          })
              .has(0.0, {1.0, 1.0, 1.0, 1.0, 1.0})
              .flat_to(1e-2),
          hs(56, {1.0, 1.0, 1.0, a, a, a, b}, all(7, kFree))
              .minimise([](auto x) { return -x(1) * x(2) * x(3); })
              .subject_to(all(4, kZero),
                          [](auto x) {
                            return list(x(1) - 4.2 * square(sin(x(4))),
                                        x(2) - 4.2 * square(sin(x(5))),
                                        x(3) - 4.2 * square(sin(x(6))),
                                        x(1) + 2.0 * (x(2) + x(3)) - 7.2 * square(sin(x(7))));
                          })
              .has(-3.456,
                   {2.4, 1.2, 1.2, std::asin(std::sqrt(4.0 / 7.0)), std::asin(std::sqrt(2.0 / 7.0)),
                    std::asin(std::sqrt(2.0 / 7.0)), std::numbers::pi / 2.0}),
          hs(77, {2.0, 2.0, 2.0, 2.0, 2.0}, all(5, kFree))
              .minimise([](auto x) {
                return square(x(1) - 1.0) + square(x(1) - x(2)) + square(x(3) - 1.0) +
                       fourth(x(4) - 1.0) + square(cube(x(5) - 1.0));
              })
              .subject_to({{2.0 * kRoot2, 2.0 * kRoot2}, {8.0 + kRoot2, 8.0 + kRoot2}},
                          [](auto x) {
                            return list(square(x(1)) * x(4) + sin(x(4) - x(5)),
                                        x(2) + fourth(x(3)) * square(x(4)));
                          })
              .has(0.24150513, {1.166172, 1.182111, 1.380257, 1.506036, 0.6109203}),
          hs(78, {-2.0, 1.5, 2.0, -1.0, -1.0}, all(5, kFree))
              .minimise([](auto x) { return x(1) * x(2) * x(3) * x(4) * x(5); })
              .subject_to({{10.0, 10.0}, kZero, {-1.0, -1.0}},
                          [](auto x) {
                            return list(square(x(1)) + square(x(2)) + square(x(3)) + square(x(4)) +
                                            square(x(5)),
                                        x(2) * x(3) - 5.0 * x(4) * x(5), cube(x(1)) + cube(x(2)));
                          })
              .has(-2.91970041, {-1.717142, 1.595708, 1.827248, -0.7636429, -0.7636435}),
          hs(79, {2.0, 2.0, 2.0, 2.0, 2.0}, all(5, kFree))
              .minimise([](auto x) {
                return square(x(1) - 1.0) + square(x(1) - x(2)) + square(x(2) - x(3)) +
                       fourth(x(3) - x(4)) + fourth(x(4) - x(5));
              })
              .subject_to({kZero, kZero, kZero},
                          [](auto x) {
                            return list(x(1) + square(x(2)) + cube(x(3)) - 2.0 - 3.0 * kRoot2,
                                        x(2) - square(x(3)) + x(4) + 2.0 - 2.0 * kRoot2,
                                        x(1) * x(5) - 2.0);
                          })
              .has(0.0787768209, {1.191127, 1.362603, 1.472818, 1.635017, 1.679081})};
}

}  // namespace

std::vector<PublishedProblem> problems_with_equations() {
  std::vector<PublishedProblem> problems;
  for (auto part :
       {of_two_unknowns, of_three_or_four_unknowns, with_linear_equations, with_curved_equations}) {
    for (PublishedProblem& problem : part()) problems.push_back(std::move(problem));
  }
  return problems;
}

}  // namespace torquewright::optimization
