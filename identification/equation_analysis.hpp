// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/analysis.hpp"
#include "identification/equation.hpp"

namespace torquewright::identification {

/// One equation, from its Gram to its result: errors, names, groups and verdict. `replicas`: the
/// signals with noise added once more. Where too little can be fitted, the result says so.
EquationResult analyse_equation(const Bench& bench, const Log& log, Equation equation,
                                const std::vector<Signals>& signals,
                                const std::vector<std::vector<Signals>>& replicas,
                                const AnalysisOptions& options);

}  // namespace torquewright::identification
