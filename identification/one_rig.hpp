// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/equation.hpp"

namespace torquewright::identification {

/// Why the runs of a log cannot be of one rig: two of them ask for values of an uncertain constant
/// that differ by more than a factor of two and six standard errors, all else as fitted to all.
/// Empty: they can. `run_of_block`: a number for each run's name.
std::string not_one_rig(const Fitter& fitter, const Fit& model, const Equation& equation,
                        const std::vector<std::size_t>& run_of_block,
                        const std::vector<std::string>& run_names);

}  // namespace torquewright::identification
