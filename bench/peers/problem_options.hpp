// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "gearbox/problem.hpp"
#include "src/command_line/command_line.hpp"

namespace torquewright::bench {

/// The paper's problem on a command line. Decimals are kept as text, so that they stay exact.
struct ProblemOptions {
  std::string ratio = "20";
  std::string tolerance = "0";
  std::string diameter_mm = "79.4";
  std::string module_mm = "0.6";
  std::string alpha_min_rad = "0";
  std::int64_t planets = 4;
  std::vector<std::int64_t> minima{12, 12, 12};  ///< Sun, planet 1, planet 2.
  bool rings_eliminated = false;
  double start = 0.5;  ///< Of the way from the least to the greatest value of each variable.
  int resolves = 0;    ///< Bonmin's num_resolve_*: other starting points tried.
  double time_limit_s = 60;
  bool check = true;

  gearbox::Problem problem() const;
};

void add_problem_options(command_line::Command& program, ProblemOptions& options);

/// The same problem as command-line arguments.
std::vector<std::string> problem_arguments(const gearbox::Problem& problem);

}  // namespace torquewright::bench
