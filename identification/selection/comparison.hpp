// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/selection/model_fit.hpp"

namespace torquewright::identification {

/// What one model gains over another on blocks that neither was fitted to.
struct Comparison {
  double gain = 0.0;           ///< Loss of the one less that of the other.
  double error = 0.0;          ///< Of that gain.
  double t = 0.0;              ///< Gain over its error.
  double change_rms = 0.0;     ///< Between the two models' predictions, over the training rows.
  double held_out_gain = 0.0;  ///< On blocks that no fit sees; 0 without any.
  std::size_t parts = 0, parts_better = 0;  ///< Folds, and those in which it gains.
};

/// The gain of `more` over `less` where neither was fitted. If `more` is true, a block's gain is
/// the square of what the predictions differ by, and a noise that is twice the residual times that
/// difference: the error is of this noise, with the correlation of neighbouring blocks.
/// docs/derivations/identification.md section 12.
Comparison compare(const Rows& rows, const ModelFit& less, const ModelFit& more);

/// The t beyond which chance alone, in `trials` trials, goes with probability `chance`: Student's
/// distribution with as many degrees of freedom as there are blocks, to second order.
double threshold_t(double chance, std::size_t trials, std::size_t blocks);

}  // namespace torquewright::identification
