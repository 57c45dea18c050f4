// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/result.hpp"

namespace torquewright::report {

/// Scripts for gnuplot, as SVG.

/// Error with the nominal model and after each effect, beside the noise floor.
std::string waterfall_plot(const identification::EquationResult& equation);

/// The mean residual over each coordinate, before and after; empty where there is none.
std::string structure_plot(const identification::EquationResult& equation);

}  // namespace torquewright::report
