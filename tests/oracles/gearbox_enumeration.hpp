// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "gearbox/problem.hpp"
#include "tests/oracles/gearbox_rules.hpp"

namespace torquewright::oracles {

/// A design that satisfies every constraint, in few bytes: there may be millions.
struct Found {
  Teeth teeth;
  std::int64_t planet_count = 0;
  std::size_t module_index = 0;  ///< Into Problem::module_mm.
  long double objective = 0;
};

/// A design whose fate hangs on a rounded margin.
struct NearTie {
  Found design;
  std::string constraint;
  long double margin = 0;
};

struct Enumeration {
  std::vector<Found> feasible;     ///< All of them, in the order of the loops.
  std::vector<Found> best;         ///< The best and what ties with it; empty if infeasible.
  std::vector<NearTie> near_ties;  ///< The answer can be trusted only if this is empty.
};

enum class Loops {
  kAll,      ///< Every triple of sun, planet 1 and planet 2 (pairs in a single stage).
  kInverse,  ///< The last count from the interval the ratio leaves it. Needs `ratio` and
             ///< `tooth_difference` to be enforced.
};

/// Looks at every planet count, module and tooth count within the rotor's bore, which is always
/// enforced. Ties: the paper's cost as a fraction, all others within 1e-12 relatively.
Enumeration enumerate(const gearbox::Problem& problem, Loops loops = Loops::kInverse,
                      const Switches& off = {});

/// Names of the constraints that a design violates; its rings are taken as they are.
std::vector<std::string> violations(const gearbox::Problem& problem, const gearbox::Design& design,
                                    const Switches& off = {});

/// All teeth in the topology's order.
gearbox::Design to_design(const gearbox::Problem& problem, const Found& found);

}  // namespace torquewright::oracles
