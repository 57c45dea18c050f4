// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/selection/model_fit.hpp"

namespace torquewright::identification {

/// An addition to a model that looks promising by a linear estimate, before it is fitted.
struct Prospect {
  EffectSet added;        ///< One added effect, or more.
  Eigen::VectorXd start;  ///< Coordinates of the whole model with the addition.
  double loss = 0.0;      ///< Loss of the training rows by the linear estimate.
};

struct Screening {
  std::vector<Prospect> singles, pairs;  ///< Single effects and pairs, the most promising first.
  std::vector<Prospect> combs;           ///< The most promising waves of one kind, together.
  std::vector<const EffectCandidate*> silent;  ///< Effects that the log does not excite.
};

/// Screens every candidate that the model does not hold, by linear least squares with the slopes of
/// the model and those of the candidate at each of its starts; then pairs of their best starts.
/// `least_change_rms`: what the largest sensible value of a parameter has to change in the
/// prediction, else the log does not excite it.
Screening screen(const ModelFitter& fitter, const ModelFit& model, const EffectSet& candidates,
                 double least_change_rms, bool with_pairs);

}  // namespace torquewright::identification
