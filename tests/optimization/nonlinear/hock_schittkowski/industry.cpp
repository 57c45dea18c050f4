// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "tests/optimization/nonlinear/hock_schittkowski/powers.hpp"
#include "tests/optimization/nonlinear/hock_schittkowski/published_problem.hpp"

namespace torquewright::optimization {
namespace {

std::vector<PublishedProblem> of_reciprocals() {
  return {
      hs(64, {1.0, 1.0, 1.0}, all(3, {1e-5, kInfinity}))
          .minimise([](auto x) {
            return 5.0 * x(1) + 50000.0 / x(1) + 20.0 * x(2) + 72000.0 / x(2) + 10.0 * x(3) +
                   144000.0 / x(3);
          })
          .subject_to({kNotNegative},
                      [](auto x) { return list(1.0 - 4.0 / x(1) - 32.0 / x(2) - 120.0 / x(3)); })
          .has(6299.842428, {108.7347175, 85.12613942, 204.3247078}),
      // Unknowns of some hundreds between bounds of 1e-3 and 4e5.
      hs(72, {1.0, 1.0, 1.0, 1.0}, {{1e-3, 4e5}, {1e-3, 3e5}, {1e-3, 2e5}, {1e-3, 1e5}})
          .minimise([](auto x) { return 1.0 + x(1) + x(2) + x(3) + x(4); })
          .subject_to({kNotNegative, kNotNegative},
                      [](auto x) {
                        return list(0.0401 - 4.0 / x(1) - 2.25 / x(2) - 1.0 / x(3) - 0.25 / x(4),
                                    0.010085 - 0.16 / x(1) - 0.36 / x(2) -
                                        0.64 * (1.0 / x(3) + 1.0 / x(4)));
                      })
          .has(727.67937, {193.4071, 179.5475, 185.0186, 168.7062})
          .flat_to(1e-5),
  };
}

/// Costs of six processes, nearly all at their bounds; coefficients from 17 to 26000.
PublishedProblem processes(int number, double first, double second, double optimum,
                           std::vector<double> minimiser) {
  return hs(number, std::vector<double>(6, 0.0),
            {{0, 0.31}, {0, 0.046}, {0, 0.068}, {0, 0.042}, {0, 0.028}, {0, 0.0134}})
      .minimise([](auto x) {
        return 4.3 * x(1) + 31.8 * x(2) + 63.3 * x(3) + 15.8 * x(4) + 68.5 * x(5) + 4.7 * x(6);
      })
      .subject_to(
          {{first, kInfinity}, {second, kInfinity}, {-29.08, kInfinity}, {-78.02, kInfinity}},
          [](auto x) {
            return list(17.1 * x(1) + 38.2 * x(2) + 204.2 * x(3) + 212.3 * x(4) + 623.4 * x(5) +
                            1495.5 * x(6) - 169.0 * x(1) * x(3) - 3580.0 * x(3) * x(5) -
                            3810.0 * x(4) * x(5) - 18500.0 * x(4) * x(6) - 24300.0 * x(5) * x(6),
                        17.9 * x(1) + 36.8 * x(2) + 113.9 * x(3) + 169.7 * x(4) + 337.8 * x(5) +
                            1385.2 * x(6) - 139.0 * x(1) * x(3) - 2450.0 * x(4) * x(5) -
                            16600.0 * x(4) * x(6) - 17200.0 * x(5) * x(6),
                        -273.0 * x(2) - 70.0 * x(4) - 819.0 * x(5) + 26000.0 * x(4) * x(5),
                        159.9 * x(1) - 311.0 * x(2) + 587.0 * x(4) + 391.0 * x(5) + 2198.0 * x(6) -
                            14000.0 * x(1) * x(6));
          })
      .has(optimum, std::move(minimiser));
}

// Of Colville's first problem and his second, which is its dual.
constexpr std::size_t kProducts = 5, kResources = 10;
constexpr std::array<double, kProducts> kLinear = {-15, -27, -36, -18, -12};
constexpr std::array<double, kProducts> kCubic = {4, 8, 10, 6, 2};
constexpr std::array<std::array<double, kProducts>, kProducts> kQuadratic = {
    {{30, -20, -10, 32, -10},
     {-20, 39, -6, -31, 32},
     {-10, -6, 10, -6, -10},
     {32, -31, -6, 39, -20},
     {-10, 32, -10, -20, 30}}};
constexpr std::array<std::array<double, kProducts>, kResources> kUses = {{{-16, 2, 0, 1, 0},
                                                                          {0, -2, 0, 0.4, 2},
                                                                          {-3.5, 0, 2, 0, 0},
                                                                          {0, -2, 0, -4, -1},
                                                                          {0, -9, -2, 1, -2.8},
                                                                          {2, 0, -4, 0, 0},
                                                                          {-1, -1, -1, -1, -1},
                                                                          {-1, -2, -3, -2, -1},
                                                                          {1, 2, 3, 4, 5},
                                                                          {1, 1, 1, 1, 1}}};
constexpr std::array<double, kResources> kLeast = {-40, -2, -0.25, -4, -4, -1, -40, -60, 5, 1};

PublishedProblem colville_1() {
  constexpr auto cost = [](auto x) {
    typename decltype(x)::Kind sum(0.0);
    for (std::size_t j = 0; j < kProducts; ++j) {
      sum += kLinear[j] * x(j + 1) + kCubic[j] * cube(x(j + 1));
      for (std::size_t i = 0; i < kProducts; ++i) sum += kQuadratic[i][j] * x(i + 1) * x(j + 1);
    }
    return sum;
  };
  constexpr auto rows = [](auto x) {
    std::vector<typename decltype(x)::Kind> uses(kResources, -0.0);
    for (std::size_t i = 0; i < kResources; ++i) {
      for (std::size_t j = 0; j < kProducts; ++j) uses[i] += kUses[i][j] * x(j + 1);
      uses[i] -= kLeast[i];
    }
    return uses;
  };
  return hs(86, {0.0, 0.0, 0.0, 0.0, 1.0}, all(kProducts, kNotNegative))
      .minimise(cost)
      .subject_to(all(kResources, kNotNegative), rows)
      .has(-32.34867897, {0.3, 0.33346761, 0.4, 0.42831010, 0.22396487});
}

PublishedProblem colville_2() {
  constexpr auto cost = [](auto x) {
    typename decltype(x)::Kind sum(0.0);
    for (std::size_t i = 0; i < kResources; ++i) sum -= kLeast[i] * x(i + 1);
    for (std::size_t j = 0; j < kProducts; ++j) {
      sum += 2.0 * kCubic[j] * cube(x(kResources + j + 1));
      for (std::size_t i = 0; i < kProducts; ++i) {
        sum += kQuadratic[i][j] * x(kResources + i + 1) * x(kResources + j + 1);
      }
    }
    return sum;
  };
  constexpr auto rows = [](auto x) {
    std::vector<typename decltype(x)::Kind> slopes(kProducts, 0.0);
    for (std::size_t j = 0; j < kProducts; ++j) {
      for (std::size_t i = 0; i < kProducts; ++i) {
        slopes[j] += 2.0 * kQuadratic[i][j] * x(kResources + i + 1);
      }
      slopes[j] += 3.0 * kCubic[j] * square(x(kResources + j + 1)) + kLinear[j];
      for (std::size_t i = 0; i < kResources; ++i) slopes[j] -= kUses[i][j] * x(i + 1);
    }
    return slopes;
  };
  std::vector<double> start(kResources + kProducts, 0.001);
  start[6] = 60.0;
  return hs(117, start, all(kResources + kProducts, kNotNegative))
      .minimise(cost)
      .subject_to(all(kProducts, kNotNegative), rows)
      .has(32.348679, {0.0, 0.0, 5.174136, 0.0, 3.061093, 11.83968, 0.0, 0.0, 0.1039071, 0.0,
                       0.2999929, 0.3334709, 0.3999910, 0.4283145, 0.2239607})
      .flat_to(3e-5);
}

/// Rows with bounds on either side, numbers up to 40792.
PublishedProblem colville_3() {
  constexpr auto cost = [](auto x) {
    return 5.3578547 * square(x(3)) + 0.8356891 * x(1) * x(5) + 37.293239 * x(1) - 40792.141;
  };
  constexpr auto rows = [](auto x) {
    return list(
        85.334407 + 0.0056858 * x(2) * x(5) + 0.0006262 * x(1) * x(4) - 0.0022053 * x(3) * x(5),
        80.51249 + 0.0071317 * x(2) * x(5) + 0.0029955 * x(1) * x(2) + 0.0021813 * square(x(3)),
        9.300961 + 0.0047026 * x(3) * x(5) + 0.0012547 * x(1) * x(3) + 0.0019085 * x(3) * x(4));
  };
  return hs(83, {78.0, 33.0, 27.0, 27.0, 27.0}, {{78, 102}, {33, 45}, {27, 45}, {27, 45}, {27, 45}})
      .minimise(cost)
      .subject_to({{0, 92}, {90, 110}, {20, 25}}, rows)
      .has(-30665.53867, {78.0, 33.0, 29.99526, 45.0, 36.77581});
}

PublishedProblem transformer() {
  constexpr auto cost = [](auto x) {
    const auto window = x(1) + x(2) + x(3), core = x(1) + 1.57 * x(2) + x(4);
    return 0.0204 * x(1) * x(4) * window + 0.0187 * x(2) * x(3) * core +
           0.0607 * x(1) * x(4) * square(x(5)) * window +
           0.0437 * x(2) * x(3) * square(x(6)) * core;
  };
  constexpr auto rows = [](auto x) {
    const auto window = x(1) + x(2) + x(3), core = x(1) + 1.57 * x(2) + x(4);
    return list(0.001 * x(1) * x(2) * x(3) * x(4) * x(5) * x(6) - 2.07,
                1.0 - 0.00062 * x(1) * x(4) * square(x(5)) * window -
                    0.00058 * x(2) * x(3) * square(x(6)) * core);
  };
  return hs(93, {5.54, 4.4, 12.02, 11.82, 0.702, 0.852}, all(6, kNotNegative))
      .minimise(cost)
      .subject_to({kNotNegative, kNotNegative}, rows)
      .has(135.075961, {5.332666, 4.656744, 10.43299, 12.08230, 0.7526074, 0.87865084});
}

PublishedProblem seven_unknowns() {
  constexpr auto cost = [](auto x) {
    return square(x(1) - 10.0) + 5.0 * square(x(2) - 12.0) + fourth(x(3)) +
           3.0 * square(x(4) - 11.0) + 10.0 * square(cube(x(5))) + 7.0 * square(x(6)) +
           fourth(x(7)) - 4.0 * x(6) * x(7) - 10.0 * x(6) - 8.0 * x(7);
  };
  constexpr auto rows = [](auto x) {
    return list(
        127.0 - 2.0 * square(x(1)) - 3.0 * fourth(x(2)) - x(3) - 4.0 * square(x(4)) - 5.0 * x(5),
        282.0 - 7.0 * x(1) - 3.0 * x(2) - 10.0 * square(x(3)) - x(4) + x(5),
        196.0 - 23.0 * x(1) - square(x(2)) - 6.0 * square(x(6)) + 8.0 * x(7),
        -4.0 * square(x(1)) - square(x(2)) + 3.0 * x(1) * x(2) - 2.0 * square(x(3)) - 5.0 * x(6) +
            11.0 * x(7));
  };
  return hs(100, {1.0, 2.0, 0.0, 4.0, 0.0, 1.0, 1.0}, all(7, kFree))
      .minimise(cost)
      .subject_to(all(4, kNotNegative), rows)
      .has(680.6300573, {2.330499, 1.951372, -0.4775414, 4.365726, -0.6244870, 1.038131, 1.594227});
}

PublishedProblem reactors() {
  constexpr auto cost = [](auto x) {
    return 0.4 * power(x(1) / x(7), 0.67) + 0.4 * power(x(2) / x(8), 0.67) + 10.0 - x(1) - x(2);
  };
  constexpr auto rows = [cost](auto x) {
    return list(1.0 - 0.0588 * x(5) * x(7) - 0.1 * x(1),
                1.0 - 0.0588 * x(6) * x(8) - 0.1 * (x(1) + x(2)),
                1.0 - 4.0 * x(3) / x(5) - 2.0 * power(x(3), -0.71) / x(5) -
                    0.0588 * power(x(3), -1.3) * x(7),
                1.0 - 4.0 * x(4) / x(6) - 2.0 * power(x(4), -0.71) / x(6) -
                    0.0588 * power(x(4), -1.3) * x(8),
                cost(x));
  };
  return hs(104, {6.0, 3.0, 0.4, 0.2, 6.0, 6.0, 1.0, 0.5}, all(8, {0.1, 10.0}))
      .minimise(cost)
      .subject_to({kNotNegative, kNotNegative, kNotNegative, kNotNegative, {1.0, 4.2}}, rows)
      .has(3.9511634396,
           {6.465114, 2.232709, 0.6673975, 0.5957564, 5.932676, 5.527235, 1.013322, 0.4006682});
}

/// Temperatures of some hundreds, areas of some thousands, rows of 1 and of 1e6. What is published
/// is feasible, and 1.2e-5 from optimal.
PublishedProblem heat_exchangers() {
  constexpr auto rows = [](auto x) {
    return list(1.0 - 0.0025 * (x(4) + x(6)), 1.0 - 0.0025 * (x(5) + x(7) - x(4)),
                1.0 - 0.01 * (x(8) - x(5)),
                x(1) * x(6) - 833.33252 * x(4) - 100.0 * x(1) + 83333.333,
                x(2) * x(7) - 1250.0 * x(5) - x(2) * x(4) + 1250.0 * x(4),
                x(3) * x(8) - 1.25e6 - x(3) * x(5) + 2500.0 * x(5));
  };
  return hs(106, {5000.0, 5000.0, 5000.0, 200.0, 350.0, 150.0, 225.0, 425.0},
            {{100, 1e4},
             {1e3, 1e4},
             {1e3, 1e4},
             {10, 1e3},
             {10, 1e3},
             {10, 1e3},
             {10, 1e3},
             {10, 1e3}})
      .minimise([](auto x) { return x(1) + x(2) + x(3); })
      .subject_to(all(6, kNotNegative), rows)
      .has(7049.330923,
           {579.3167, 1359.943, 5110.071, 182.0174, 295.5985, 217.9799, 286.4162, 395.5979})
      .printed_to(2e-5)
      .flat_to(3e-5);
}

PublishedProblem ten_unknowns() {
  constexpr auto cost = [](auto x) {
    return square(x(1)) + square(x(2)) + x(1) * x(2) - 14.0 * x(1) - 16.0 * x(2) +
           square(x(3) - 10.0) + 4.0 * square(x(4) - 5.0) + square(x(5) - 3.0) +
           2.0 * square(x(6) - 1.0) + 5.0 * square(x(7)) + 7.0 * square(x(8) - 11.0) +
           2.0 * square(x(9) - 10.0) + square(x(10) - 7.0) + 45.0;
  };
  constexpr auto rows = [](auto x) {
    return list(
        105.0 - 4.0 * x(1) - 5.0 * x(2) + 3.0 * x(7) - 9.0 * x(8),
        -10.0 * x(1) + 8.0 * x(2) + 17.0 * x(7) - 2.0 * x(8),
        8.0 * x(1) - 2.0 * x(2) - 5.0 * x(9) + 2.0 * x(10) + 12.0,
        120.0 - 3.0 * square(x(1) - 2.0) - 4.0 * square(x(2) - 3.0) - 2.0 * square(x(3)) +
            7.0 * x(4),
        40.0 - 5.0 * square(x(1)) - 8.0 * x(2) - square(x(3) - 6.0) + 2.0 * x(4),
        30.0 - 0.5 * square(x(1) - 8.0) - 2.0 * square(x(2) - 4.0) - 3.0 * square(x(5)) + x(6),
        -square(x(1)) - 2.0 * square(x(2) - 2.0) + 2.0 * x(1) * x(2) - 14.0 * x(5) + 6.0 * x(6),
        3.0 * x(1) - 6.0 * x(2) - 12.0 * square(x(9) - 8.0) + 7.0 * x(10));
  };
  return hs(113, {2.0, 3.0, 5.0, 5.0, 1.0, 2.0, 7.0, 3.0, 6.0, 10.0}, all(10, kFree))
      .minimise(cost)
      .subject_to(all(8, kNotNegative), rows)
      .has(24.3062091, {2.171996, 2.363683, 8.773926, 5.095984, 0.9906548, 1.430574, 1.321644,
                        9.828726, 8.280092, 8.375927});
}

}  // namespace

std::vector<PublishedProblem> problems_of_industry() {
  std::vector<PublishedProblem> problems = of_reciprocals();
  problems.push_back(processes(95, 4.97, -1.88, 0.015619514, {0, 0, 0, 0, 0, 0.00332330328}));
  // Found: the sixth process as far as it goes, the rest by the third, which the first row asks
  // for.
  const double third = (32.97 - 1495.5 * 0.0134) / 204.2;
  problems.push_back(processes(97, 32.97, 25.12, 3.1358091, {0.268565, 0, 0, 0, 0.028, 0.0134})
                         .ending_at(63.3 * third + 4.7 * 0.0134));
  for (auto problem : {colville_1, colville_2, colville_3, transformer, seven_unknowns, reactors,
                       heat_exchangers, ten_unknowns}) {
    problems.push_back(problem());
  }
  return problems;
}

}  // namespace torquewright::optimization
