// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "tests/optimization/nonlinear/hock_schittkowski/powers.hpp"
#include "tests/optimization/nonlinear/hock_schittkowski/published_problem.hpp"

namespace torquewright::optimization {
namespace {

constexpr auto kMinusVolume = [](auto x) { return -x(1) * x(2) * x(3); };
constexpr auto kTwoExponentials = [](auto x) {
  return list(x(2) - exponential(x(1)), x(3) - exponential(x(2)));
};

std::vector<PublishedProblem> of_volumes() {
  return {
      hs(29, {1.0, 1.0, 1.0}, all(3, kFree))
          .minimise(kMinusVolume)
          .subject_to({kNotNegative},
                      [](auto x) {
                        return list(48.0 - square(x(1)) - 2.0 * square(x(2)) - 4.0 * square(x(3)));
                      })
          .has(-16.0 * kRoot2, {4.0, 2.0 * kRoot2, 2.0}),
      hs(36, {10.0, 10.0, 10.0}, {{0, 20}, {0, 11}, {0, 42}})
          .minimise(kMinusVolume)
          .subject_to({kNotNegative},
                      [](auto x) { return list(72.0 - x(1) - 2.0 * (x(2) + x(3))); })
          .has(-3300.0, {20.0, 11.0, 15.0}),
      hs(37, {10.0, 10.0, 10.0}, all(3, {0.0, 42.0}))
          .minimise(kMinusVolume)
          .subject_to({{0.0, 72.0}}, [](auto x) { return list(x(1) + 2.0 * (x(2) + x(3))); })
          .has(-3456.0, {24.0, 12.0, 12.0}),
  };
}

std::vector<PublishedProblem> of_three_unknowns() {
  const double ln10 = std::numbers::ln10;
  return {
      // The row's slopes are those of a bound that is active too: multipliers are not unique.
      hs(30, {1.0, 1.0, 1.0}, {{1, 10}, {-10, 10}, {-10, 10}})
          .minimise([](auto x) { return square(x(1)) + square(x(2)) + square(x(3)); })
          .subject_to({kNotNegative},
                      [](auto x) { return list(square(x(1)) + square(x(2)) - 1.0); })
          .has(1.0, {1.0, 0.0, 0.0}),
      hs(31, {1.0, 1.0, 1.0}, {{-10, 10}, {1, 10}, {-10, 1}})
          .minimise([](auto x) { return 9.0 * square(x(1)) + square(x(2)) + 9.0 * square(x(3)); })
          .subject_to({kNotNegative}, [](auto x) { return list(x(1) * x(2) - 1.0); })
          .has(6.0, {1.0 / kRoot3, kRoot3, 0.0}),
      hs(33, {0.0, 0.0, 3.0}, {kNotNegative, kNotNegative, {0, 5}})
          .minimise([](auto x) { return (x(1) - 1.0) * (x(1) - 2.0) * (x(1) - 3.0) + x(3); })
          .subject_to({kNotNegative, kNotNegative},
                      [](auto x) {
                        return list(square(x(3)) - square(x(2)) - square(x(1)),
                                    square(x(1)) + square(x(2)) + square(x(3)) - 4.0);
                      })
          .has(kRoot2 - 6.0, {0.0, kRoot2, kRoot2}),
      hs(34, {0.0, 1.05, 2.9}, {{0, 100}, {0, 100}, {0, 10}})
          .minimise([](auto x) { return -x(1); })
          .subject_to({kNotNegative, kNotNegative}, kTwoExponentials)
          .has(-std::log(ln10), {std::log(ln10), ln10, 10.0}),
      hs(35, {0.5, 0.5, 0.5}, all(3, kNotNegative))
          .minimise([](auto x) {
            return 9.0 - 8.0 * x(1) - 6.0 * x(2) - 4.0 * x(3) + 2.0 * square(x(1)) +
                   2.0 * square(x(2)) + square(x(3)) + 2.0 * x(1) * (x(2) + x(3));
          })
          .subject_to({kNotNegative}, [](auto x) { return list(3.0 - x(1) - x(2) - 2.0 * x(3)); })
          .has(1.0 / 9.0, {4.0 / 3.0, 7.0 / 9.0, 4.0 / 9.0}),
      hs(65, {-5.0, 5.0, 0.0}, {{-4.5, 4.5}, {-4.5, 4.5}, {-5, 5}})
          .minimise([](auto x) {
            return square(x(1) - x(2)) + square(x(1) + x(2) - 10.0) / 9.0 + square(x(3) - 5.0);
          })
          .subject_to(
              {kNotNegative},
              [](auto x) { return list(48.0 - square(x(1)) - square(x(2)) - square(x(3))); })
          .has(0.9535288567, {3.650461821, 3.65046168, 4.6204170507}),
      hs(66, {0.0, 1.05, 2.9}, {{0, 100}, {0, 100}, {0, 10}})
          .minimise([](auto x) { return 0.2 * x(3) - 0.8 * x(1); })
          .subject_to({kNotNegative, kNotNegative}, kTwoExponentials)
          .has(0.5181632741, {0.1841264879, 1.202167873, 3.327322322}),
  };
}

std::vector<PublishedProblem> of_four_unknowns() {
  return {
      // Rosen and Suzuki.
      hs(43, {0.0, 0.0, 0.0, 0.0}, all(4, kFree))
          .minimise([](auto x) {
            return square(x(1)) + square(x(2)) + 2.0 * square(x(3)) + square(x(4)) -
                   5.0 * (x(1) + x(2)) - 21.0 * x(3) + 7.0 * x(4);
          })
          .subject_to(all(3, kNotNegative),
                      [](auto x) {
                        return list(8.0 - square(x(1)) - square(x(2)) - square(x(3)) -
                                        square(x(4)) - x(1) + x(2) - x(3) + x(4),
                                    10.0 - square(x(1)) - 2.0 * square(x(2)) - square(x(3)) -
                                        2.0 * square(x(4)) + x(1) + x(4),
                                    5.0 - 2.0 * square(x(1)) - square(x(2)) - square(x(3)) -
                                        2.0 * x(1) + x(2) + x(4));
                      })
          .has(-44.0, {0.0, 1.0, 2.0, -1.0}),
      // Not convex: vertices are local optima, such as (3, 0, 4, 0).
      hs(44, {0.0, 0.0, 0.0, 0.0}, all(4, kNotNegative))
          .minimise([](auto x) {
            return x(1) - x(2) - x(3) - x(1) * x(3) + x(1) * x(4) + x(2) * x(3) - x(2) * x(4);
          })
          .subject_to(all(6, kNotNegative),
                      [](auto x) {
                        return list(8.0 - x(1) - 2.0 * x(2), 12.0 - 4.0 * x(1) - x(2),
                                    12.0 - 3.0 * x(1) - 4.0 * x(2), 8.0 - 2.0 * x(3) - x(4),
                                    8.0 - x(3) - 2.0 * x(4), 5.0 - x(3) - x(4));
                      })
          .has(-15.0, {0.0, 3.0, 0.0, 4.0})
          .ending_at(-13.0),
      hs(76, {0.5, 0.5, 0.5, 0.5}, all(4, kNotNegative))
          .minimise([](auto x) {
            return square(x(1)) + 0.5 * square(x(2)) + square(x(3)) + 0.5 * square(x(4)) -
                   x(1) * x(3) + x(3) * x(4) - x(1) - 3.0 * x(2) + x(3) - x(4);
          })
          .subject_to(all(3, kNotNegative),
                      [](auto x) {
                        return list(5.0 - x(1) - 2.0 * x(2) - x(3) - x(4),
                                    4.0 - 3.0 * x(1) - x(2) - 2.0 * x(3) + x(4),
                                    x(2) + 4.0 * x(3) - 1.5);
                      })
          .has(-4.681818181, {3.0 / 11.0, 23.0 / 11.0, 0.0, 6.0 / 11.0}),
  };
}

}  // namespace

std::vector<PublishedProblem> problems_in_space() {
  std::vector<PublishedProblem> problems;
  for (auto part : {of_volumes, of_three_unknowns, of_four_unknowns}) {
    for (PublishedProblem& problem : part()) problems.push_back(std::move(problem));
  }
  return problems;
}

}  // namespace torquewright::optimization
