// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "gearbox/problem.hpp"

namespace torquewright::oracles {

struct Minima {
  std::int64_t sun;
  std::int64_t planet_1;
  std::int64_t planet_2;
};

/// The paper's problem, 20:1 exactly, rotor 79.4 mm, module 0.6 mm, four planets, with the bounds
/// that the paper keeps to itself.
gearbox::Problem paper_problem(const Minima& minima, const io::Rational& alpha_min_rad);

/// The published actuator: minima 40/40/30 and 0.26 rad make 44/44/32 the optimum.
gearbox::Problem d151_problem();

/// A problem on which a widely used solver was seen to fail, with the right answer.
struct HardProblem {
  gearbox::Problem problem;
  std::vector<std::int64_t> teeth;  ///< S, P1, P2, F, O.
};
std::vector<HardProblem> hard_problems();

}  // namespace torquewright::oracles
