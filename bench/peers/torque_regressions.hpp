// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/equation_fit.hpp"

namespace torquewright::bench {

/// What people do with the regressors of a torque equation, without runs held out, limits or noise
/// taken off. Each returns the effects that it names.

/// Coulomb and viscous friction and nothing else; named where |t| > 3.
std::vector<std::string> fixed_friction(const identification::EquationFit& fit);

/// Of every effect the variant that alone leaves least, all of them at once; named where a
/// coefficient has |t| > 3. Columns that depend on those before them are left out.
std::vector<std::string> everything(const identification::EquationFit& fit);

/// The variant that leaves least joins while n ln(RSS/n) + k ln n falls, n the samples in the band.
std::vector<std::string> greedy_by_bic(const identification::EquationFit& fit);

}  // namespace torquewright::bench
