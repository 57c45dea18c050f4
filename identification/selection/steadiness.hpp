// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/selection/model_fit.hpp"

namespace torquewright::identification {

/// How much better a member's law would do if its parameters were others in other parts of the log.
struct Unsteadiness {
  std::string coordinate;  ///< Along which parts were cut.
  double share = 0.0;      ///< Of the squares that are left, beyond what chance takes.
  double squares = 0.0;    ///< The same, as a mean over the rows.
};

/// The coordinate along which a member's parameters differ most: quarters of the rows by angle,
/// speed, load, current, time, temperature, and single runs. A law that holds has the same
/// parameters everywhere. docs/derivations/identification.md section 12.
Unsteadiness unsteadiness(const ModelFitter& fitter, const ModelFit& fit, std::size_t member);

}  // namespace torquewright::identification
