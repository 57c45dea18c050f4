// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/named_problems.hpp"

namespace torquewright::oracles {

using io::Rational;

gearbox::Problem paper_problem(const Minima& minima, const Rational& alpha_min_rad) {
  gearbox::Problem problem;
  problem.name = "paper";
  problem.topology = "3k";
  problem.target_ratio = 20;
  problem.ratio_tolerance = 0;
  problem.rotor_inner_diameter_mm = Rational(397, 5);
  problem.module_mm = {Rational(3, 5)};
  problem.planet_count = {4};
  problem.min_teeth = {
      {"sun", minima.sun}, {"planet_1", minima.planet_1}, {"planet_2", minima.planet_2}};
  problem.min_carrier_clearance_rad = alpha_min_rad;
  return problem;
}

gearbox::Problem d151_problem() {
  gearbox::Problem problem = paper_problem({40, 40, 30}, Rational(13, 50));
  problem.name = "D151";
  return problem;
}

std::vector<HardProblem> hard_problems() {
  const std::vector<std::int64_t> published{44, 44, 32, 132, 120};
  const std::vector<std::int64_t> cheaper{24, 48, 28, 120, 100};
  const Rational five_degrees(174533, 2000000);  // 0.0872665 rad
  return {{paper_problem({22, 23, 32}, 0), published},
          {paper_problem({26, 34, 32}, five_degrees), published},
          {paper_problem({15, 41, 31}, 0), published},
          {paper_problem({14, 43, 11}, 0), cheaper},
          {paper_problem({11, 43, 25}, 0), cheaper}};
}

}  // namespace torquewright::oracles
