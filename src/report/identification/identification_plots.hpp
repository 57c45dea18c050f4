// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/findings/result.hpp"

namespace torquewright::report {

/// Scripts for gnuplot, as SVG.

/// Error with the nominal model and after each effect, beside the noise floor.
std::string waterfall_plot(const identification::EquationResult& equation);

/// The mean residual over each coordinate of which the log holds a channel, before and after; empty
/// where there is none. `logged`: quantities by their names.
std::string structure_plot(const identification::EquationResult& equation,
                           const std::vector<std::string>& logged);

/// Measured and predicted over time, a strip for each run; of many runs those that are held out and
/// those of which most is left. Empty where there are none.
std::string run_plot(const identification::EquationResult& equation);

/// The runs that it shows.
std::vector<const identification::RunResult*> shown_runs(
    const identification::EquationResult& equation);

}  // namespace torquewright::report
