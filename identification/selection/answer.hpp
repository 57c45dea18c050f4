// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/forward/equation.hpp"
#include "identification/preparation/held_signals.hpp"
#include "identification/selection/analysis_options.hpp"
#include "identification/signals/rows.hpp"

namespace torquewright::identification {

/// Analyses one equation, from its rows to its result: errors, names, groups and verdict. Where too
/// little can be fitted, the result says so.
EquationResult answer(const Bench& bench, const Log& log, const ForwardEquation& stated,
                      const HeldSignals& held, const std::vector<std::size_t>& fold_of_run,
                      const AnalysisOptions& options);

}  // namespace torquewright::identification
