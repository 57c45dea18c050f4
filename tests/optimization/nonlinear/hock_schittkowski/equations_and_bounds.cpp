// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <numbers>

#include "tests/optimization/nonlinear/hock_schittkowski/powers.hpp"
#include "tests/optimization/nonlinear/hock_schittkowski/published_problem.hpp"

namespace torquewright::optimization {
namespace {

std::vector<PublishedProblem> of_geometry() {
  return {
      hs(32, {0.1, 0.7, 0.2}, all(3, kNotNegative))
          .minimise(
              [](auto x) { return square(x(1) + 3.0 * x(2) + x(3)) + 4.0 * square(x(1) - x(2)); })
          .subject_to({kNotNegative, kZero},
                      [](auto x) {
                        return list(6.0 * x(2) + 4.0 * x(3) - cube(x(1)) - 3.0,
                                    1.0 - x(1) - x(2) - x(3));
                      })
          .has(1.0, {0.0, 0.0, 1.0})
          .flat_to(1e-3),
      hs(41, {2.0, 2.0, 2.0, 2.0}, {{0, 1}, {0, 1}, {0, 1}, {0, 2}})
          .minimise([](auto x) { return 2.0 - x(1) * x(2) * x(3); })
          .subject_to({kZero}, [](auto x) { return list(x(1) + 2.0 * (x(2) + x(3)) - x(4)); })
          .has(52.0 / 27.0, {2.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 2.0}),
      hs(53, {2.0, 2.0, 2.0, 2.0, 2.0}, all(5, {-10.0, 10.0}))
          .minimise([](auto x) {
            return square(x(1) - x(2)) + square(x(2) + x(3) - 2.0) + square(x(4) - 1.0) +
                   square(x(5) - 1.0);
          })
          .subject_to(
              {kZero, kZero, kZero},
              [](auto x) { return list(x(1) + 3.0 * x(2), x(3) + x(4) - 2.0 * x(5), x(2) - x(5)); })
          .has(176.0 / 43.0, {-33.0 / 43.0, 11.0 / 43.0, 27.0 / 43.0, -5.0 / 43.0, 11.0 / 43.0}),
      // Six equations, six unknowns: but one of the equations follows from the others, and a line
      // is left, along which the objective is t/3 + 16/3 + exp(t - t^2) with t = x1, least at 0 and
      // locally at 1.
      hs(55, {1.0, 2.0, 0.0, 0.0, 0.0, 2.0},
         {{0, 1}, kNotNegative, kNotNegative, {0, 1}, kNotNegative, kNotNegative})
          .minimise(
              [](auto x) { return x(1) + 2.0 * x(2) + 4.0 * x(5) + exponential(x(1) * x(4)); })
          .subject_to(all(6, kZero),
                      [](auto x) {
                        return list(x(1) + 2.0 * x(2) + 5.0 * x(5) - 6.0, x(1) + x(2) + x(3) - 3.0,
                                    x(4) + x(5) + x(6) - 2.0, x(1) + x(4) - 1.0, x(2) + x(5) - 2.0,
                                    x(3) + x(6) - 2.0);
                      })
          .has(19.0 / 3.0, {0.0, 4.0 / 3.0, 5.0 / 3.0, 1.0, 2.0 / 3.0, 1.0 / 3.0})
          .ending_at(20.0 / 3.0),
      hs(60, {2.0, 2.0, 2.0}, all(3, {-10.0, 10.0}))
          .minimise(
              [](auto x) { return square(x(1) - 1.0) + square(x(1) - x(2)) + fourth(x(2) - x(3)); })
          .subject_to({kZero},
                      [](auto x) {
                        return list(x(1) * (1.0 + square(x(2))) + fourth(x(3)) - 4.0 -
                                    3.0 * kRoot2);
                      })
          .has(0.03256820025, {1.104859024, 1.196674194, 1.535262257}),
      hs(63, {2.0, 2.0, 2.0}, all(3, kNotNegative))
          .minimise([](auto x) {
            return 1000.0 - square(x(1)) - 2.0 * square(x(2)) - square(x(3)) - x(1) * x(2) -
                   x(1) * x(3);
          })
          .subject_to({kZero, kZero},
                      [](auto x) {
                        return list(8.0 * x(1) + 14.0 * x(2) + 7.0 * x(3) - 56.0,
                                    square(x(1)) + square(x(2)) + square(x(3)) - 25.0);
                      })
          .has(961.7151721, {3.512118414, 0.2169881741, 3.552174034}),
      hs(71, {1.0, 5.0, 5.0, 1.0}, all(4, {1.0, 5.0}))
          .minimise([](auto x) { return x(1) * x(4) * (x(1) + x(2) + x(3)) + x(3); })
          .subject_to({kNotNegative, kZero},
                      [](auto x) {
                        return list(
                            x(1) * x(2) * x(3) * x(4) - 25.0,
                            square(x(1)) + square(x(2)) + square(x(3)) + square(x(4)) - 40.0);
                      })
          .has(17.0140173, {1.0, 4.7429994, 3.8211503, 1.3794082}),
  };
}

std::vector<PublishedProblem> of_a_product() {
  const std::vector<double> start = {-2.0, 2.0, 2.0, -1.0, -1.0};
  const std::vector<Bounds> bounds = {
      {-2.3, 2.3}, {-2.3, 2.3}, {-3.2, 3.2}, {-3.2, 3.2}, {-3.2, 3.2}};
  const std::vector<double> minimiser = {-1.717142, 1.595708, 1.827248, -0.7636429, -0.7636435};
  constexpr auto equations = [](auto x) {
    return list(square(x(1)) + square(x(2)) + square(x(3)) + square(x(4)) + square(x(5)) - 10.0,
                x(2) * x(3) - 5.0 * x(4) * x(5), cube(x(1)) + cube(x(2)) + 1.0);
  };
  return {hs(80, start, bounds)
              .minimise([](auto x) { return exponential(x(1) * x(2) * x(3) * x(4) * x(5)); })
              .subject_to(all(3, kZero), equations)
              .has(0.0539498478, minimiser),
          hs(81, start, bounds)
              .minimise([](auto x) {
                return exponential(x(1) * x(2) * x(3) * x(4) * x(5)) -
                       0.5 * square(cube(x(1)) + cube(x(2)) + 1.0);
              })
              .subject_to(all(3, kZero), equations)
              .has(0.0539498478, minimiser)};
}

/// Economic dispatch: powers in the thousands, angles in tenths.
PublishedProblem dispatch(int number, double widest, double optimum,
                          std::vector<double> minimiser) {
  return hs(number, {0.0, 0.0, 0.0, 0.0},
            {{0, 1200}, {0, 1200}, {-widest, widest}, {-widest, widest}})
      .minimise([](auto x) {
        return 3.0 * x(1) + 1e-6 * cube(x(1)) + 2.0 * x(2) + 2e-6 / 3.0 * cube(x(2));
      })
      .subject_to({{-widest, widest}, kZero, kZero, kZero},
                  [](auto x) {
                    using std::sin;
                    return list(
                        x(4) - x(3),
                        1000.0 * (sin(-x(3) - 0.25) + sin(-x(4) - 0.25)) + 894.8 - x(1),
                        1000.0 * (sin(x(3) - 0.25) + sin(x(3) - x(4) - 0.25)) + 894.8 - x(2),
                        1000.0 * (sin(x(4) - 0.25) + sin(x(4) - x(3) - 0.25)) + 1294.8);
                  })
      .has(optimum, std::move(minimiser));
}

/// Ten gases in equilibrium: unknowns are the logarithms of amounts that span four decades.
PublishedProblem equilibrium() {
  constexpr auto energy = [](auto x) {
    constexpr std::array<double, 10> kPotentials = {-6.089,  -17.164, -34.054, -5.914,  -24.721,
                                                    -14.986, -24.100, -10.708, -26.662, -22.179};
    typename decltype(x)::Kind total(0.0), sum(0.0);
    for (std::size_t i = 1; i <= 10; ++i) total += exponential(x(i));
    const auto all_of_it = logarithm(total);
    for (std::size_t i = 1; i <= 10; ++i) {
      sum += exponential(x(i)) * (kPotentials[i - 1] + x(i) - all_of_it);
    }
    return sum;
  };
  constexpr auto balances = [](auto x) {
    const auto amount = [&](std::size_t i) { return exponential(x(i)); };
    return list(amount(1) + 2.0 * amount(2) + 2.0 * amount(3) + amount(6) + amount(10) - 2.0,
                amount(4) + 2.0 * amount(5) + amount(6) + amount(7) - 1.0,
                amount(3) + amount(7) + amount(8) + 2.0 * amount(9) + amount(10) - 1.0);
  };
  return hs(111, std::vector<double>(10, -2.3), all(10, {-100.0, 100.0}))
      .minimise(energy)
      .subject_to(all(3, kZero), balances)
      .has(-47.76109026, {-3.201212, -1.912060, -0.2444413, -6.537489, -0.7231524, -7.267738,
                          -3.596711, -4.017769, -3.287462, -2.335582})
      .flat_to(1e-2);
}

std::vector<PublishedProblem> of_industry() {
  return {
      // Logarithms of shares; costs in the ten thousands.
      hs(62, {0.7, 0.2, 0.1}, all(3, {0.0, 1.0}))
          .minimise([](auto x) {
            const auto share = [](auto most, auto some) {
              return logarithm((most + 0.03) / (some + 0.03));
            };
            return -32.174 * (255.0 * share(x(1) + x(2) + x(3), 0.09 * x(1) + x(2) + x(3)) +
                              280.0 * share(x(2) + x(3), 0.07 * x(2) + x(3)) +
                              290.0 * share(x(3), 0.13 * x(3)));
          })
          .subject_to({kZero}, [](auto x) { return list(x(1) + x(2) + x(3) - 1.0); })
          .has(-26272.51448, {0.6178126908, 0.328202223, 0.05398508606}),
      // Cattle feed: a share of one kind is at its bound.
      hs(73, {1.0, 1.0, 1.0, 1.0}, all(4, kNotNegative))
          .minimise([](auto x) { return 24.55 * x(1) + 26.75 * x(2) + 39.0 * x(3) + 40.5 * x(4); })
          .subject_to({kNotNegative, kNotNegative, kZero},
                      [](auto x) {
                        using std::sqrt;
                        const auto variance = 0.28 * square(x(1)) + 0.19 * square(x(2)) +
                                              20.5 * square(x(3)) + 0.62 * square(x(4));
                        return list(2.3 * x(1) + 5.6 * x(2) + 11.1 * x(3) + 1.3 * x(4) - 5.0,
                                    12.0 * x(1) + 11.9 * x(2) + 41.8 * x(3) + 52.1 * x(4) - 21.0 -
                                        1.645 * sqrt(variance),
                                    x(1) + x(2) + x(3) + x(4) - 1.0);
                      })
          .has(29.894378, {0.6355216, 0.0, 0.3127019, 0.05177655}),
      dispatch(74, 0.55, 5126.4981, {679.9453, 1026.067, 0.1188764, -0.3962336}),
      dispatch(75, 0.48, 5174.4129, {776.1592, 925.1949, 0.05110879, -0.4288911}),
      equilibrium(),
  };
}

}  // namespace

std::vector<PublishedProblem> problems_with_equations_and_bounds() {
  std::vector<PublishedProblem> problems;
  for (auto part : {of_geometry, of_a_product, of_industry}) {
    for (PublishedProblem& problem : part()) problems.push_back(std::move(problem));
  }
  return problems;
}

}  // namespace torquewright::optimization
