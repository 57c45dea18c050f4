// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/equation.hpp"
#include "identification/folds.hpp"
#include "identification/residual_structure.hpp"

namespace torquewright::identification {

/// What a valid fit leaves of an equation's target, in the target's unit, over all rows of the runs
/// that may be fitted. Traces point to the signals. Where runs are cut into folds, each is cut here
/// too, so that tables are held out by pieces.
std::vector<ResidualTrace> residual_traces(const Equation& equation, const Fit& fit,
                                           const std::vector<Signals>& signals, const Folds& folds,
                                           const BandOptions& band);

}  // namespace torquewright::identification
