// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/analysis.hpp"
#include "identification/equation.hpp"
#include "identification/signal_source.hpp"

namespace torquewright::identification {

/// One equation, from its Gram to its result: errors, names, groups and verdict. Where too little
/// can be fitted, the result says so.
EquationResult analyse_equation(const Bench& bench, const Log& log, Equation equation,
                                const SignalSource& source, const AnalysisOptions& options);

}  // namespace torquewright::identification
