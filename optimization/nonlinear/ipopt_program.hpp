// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "optimization/nonlinear/search.hpp"

namespace torquewright::optimization {

/// How and where a search of Ipopt's ended.
struct SearchEnd {
  NonlinearStatus status = NonlinearStatus::kStalled;
  std::vector<double> scaled;       ///< Its last point over the scales; empty if there is none.
  std::vector<double> multipliers;  ///< Multipliers of the scaled rows and the scaled objective.
  int iterations = 0;
};

/// Runs Ipopt from the program's starts. Requires at least one free unknown, and no more equations
/// than free unknowns. Exceptions of rows and of the options' functions pass through.
SearchEnd run_ipopt(Search& search);

}  // namespace torquewright::optimization
