// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/selection/model_fit.hpp"

namespace torquewright::identification {

/// How much better a member's law would do with other parameters in other parts of the log.
struct Unsteadiness {
  std::string coordinate;  ///< Coordinate along which the parts were cut.
  double share = 0.0;      ///< Gain as a share of the squares that are left, beyond chance.
  double squares = 0.0;    ///< The same gain as a mean square over the rows.
};

/// Finds the coordinate along which a member's parameters differ most: quarters of the rows by
/// angle, speed, load, current, time, temperature, and single runs. A law that holds has the same
/// parameters everywhere (docs/derivations/identification.md section 12).
Unsteadiness unsteadiness(const ModelFitter& fitter, const ModelFit& fit, std::size_t member);

}  // namespace torquewright::identification
