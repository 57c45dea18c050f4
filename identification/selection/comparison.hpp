// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/selection/model_fit.hpp"

namespace torquewright::identification {

/// The gain of one model over another on blocks that neither was fitted to.
struct Comparison {
  double gain = 0.0;   ///< Loss of the one model less that of the other.
  double error = 0.0;  ///< Standard error of the gain.
  double t = 0.0;      ///< Gain over its error.
  /// Rms difference of the two models' predictions over the training rows.
  double change_rms = 0.0;
  double held_out_gain = 0.0;               ///< Gain on blocks that no fit sees; 0 without any.
  std::size_t parts = 0, parts_better = 0;  ///< Number of folds, and of those in which it gains.
};

/// Returns the gain of `more` over `less` where neither was fitted. If `more` is true, a block's
/// gain is the square of the difference of the predictions, plus a noise of twice the residual
/// times that difference; the error is that of this noise, with the correlation of neighbouring
/// blocks (docs/derivations/identification.md section 12).
Comparison compare(const Rows& rows, const ModelFit& less, const ModelFit& more);

/// Returns the t that chance alone exceeds in any of `trials` trials with probability `chance`:
/// Student's distribution with as many degrees of freedom as there are blocks, to second order.
double threshold_t(double chance, std::size_t trials, std::size_t blocks);

}  // namespace torquewright::identification
