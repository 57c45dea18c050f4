// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/equation_fit.hpp"
#include "identification/residual_structure.hpp"
#include "identification/search.hpp"

namespace torquewright::identification {

/// Why a member of a model is no confident name yet; empty: it is one. A name has to explain most
/// of what can be explained, and more than a table over any one coordinate, hold in runs that no
/// fit saw, keep one amplitude over the log and its parameters from run to run, and leave nothing
/// along its own coordinate. `before`: the structure of the residual without any member.
/// docs/derivations/identification.md section 6.
std::vector<std::string> failed_acceptance_tests(const EquationFit& fit, const Selection& selection,
                                                 const std::vector<ResidualStructure>& before);

}  // namespace torquewright::identification
