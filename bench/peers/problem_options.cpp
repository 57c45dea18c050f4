// SPDX-License-Identifier: Apache-2.0
#include "bench/peers/problem_options.hpp"

#include "bench/decimals.hpp"

namespace torquewright::bench {

gearbox::Problem ProblemOptions::problem() const {
  gearbox::Problem problem;
  problem.name = "from the command line";
  problem.topology = "3k";
  problem.target_ratio = from_decimal(ratio);
  problem.ratio_tolerance = from_decimal(tolerance);
  problem.rotor_inner_diameter_mm = from_decimal(diameter_mm);
  problem.module_mm = {from_decimal(module_mm)};
  problem.planet_count = {planets};
  problem.min_teeth = {
      {"sun", minima.at(0)}, {"planet_1", minima.at(1)}, {"planet_2", minima.at(2)}};
  problem.min_carrier_clearance_rad = from_decimal(alpha_min_rad);
  return problem;
}

void add_problem_options(command_line::Command& program, ProblemOptions& options) {
  program.add_option("--ratio", options.ratio, "Sun over output speed");
  program.add_option("--tolerance", options.tolerance, "Relative; 0 is exact");
  program.add_option("--rotor-inner-diameter", options.diameter_mm, "mm");
  program.add_option("--module", options.module_mm, "mm");
  program.add_option("--planets", options.planets, "Number of planets");
  program.add_option("--minima", options.minima, "Least teeth of sun, planet 1, planet 2").takes(3);
  program.add_option("--alpha-min", options.alpha_min_rad, "rad, equation (6)");
  program.add_flag("--eliminate-rings", options.rings_eliminated,
                   "Put F = S + 2 P1 and O = S + P1 + P2 in instead of keeping them as variables");
  program.add_option("--start", options.start, "Starting point, 0 least values, 1 greatest values")
      .between(0.0, 1.0);
  program.add_option("--resolves", options.resolves, "Starting points tried again at every node");
  program.add_option("--time-limit", options.time_limit_s, "s");
  program.add_flag("!--no-check", options.check, "Do not compare with the enumeration");
}

std::vector<std::string> problem_arguments(const gearbox::Problem& problem) {
  const auto teeth = [&problem](const char* gear) {
    return std::to_string(problem.min_teeth.at(gear));
  };
  return {"--ratio",
          to_decimal(problem.target_ratio),
          "--tolerance",
          to_decimal(problem.ratio_tolerance),
          "--rotor-inner-diameter",
          to_decimal(problem.rotor_inner_diameter_mm),
          "--module",
          to_decimal(problem.module_mm.at(0)),
          "--planets",
          std::to_string(problem.planet_count.at(0)),
          "--alpha-min",
          to_decimal(problem.min_carrier_clearance_rad),
          "--minima",
          teeth("sun"),
          teeth("planet_1"),
          teeth("planet_2")};
}

}  // namespace torquewright::bench
