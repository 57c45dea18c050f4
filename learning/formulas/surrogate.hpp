// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace torquewright::learning {

/// Samples of a policy whose actions are normal about a mean, independent of one another. Columns
/// are samples.
struct ActionSamples {
  Eigen::Ref<const Eigen::MatrixXf> actions;
  Eigen::Ref<const Eigen::MatrixXf> old_means;  ///< Under which the actions were taken.
  Eigen::Ref<const Eigen::VectorXd> old_log_deviations;
  Eigen::Ref<const Eigen::VectorXf> advantages;
};

/// Sums over the samples.
struct SurrogateSums {
  double surrogate = 0.0;
  double kl = 0.0;       ///< From the old policy to the new one, in closed form.
  double clipped = 0.0;  ///< Number of samples that the clip leaves without a gradient.
};

/// The clipped surrogate (Schulman et al. 2017, eq. 7) of every sample, to be maximised,
///
///   min(ratio a, clip(ratio, 1 - clip, 1 + clip) a),
///
/// for the policy of `means` and `log_deviations`. `mean_errors` (actions x samples) becomes
/// `weight` times the derivative of its negative with respect to the means; that with respect to
/// the logarithms of the deviations is added to `log_deviation_errors`, times `weight` too.
SurrogateSums surrogate_of(const ActionSamples& samples,
                           const Eigen::Ref<const Eigen::MatrixXf>& means,
                           const Eigen::Ref<const Eigen::VectorXd>& log_deviations, double clip,
                           double weight, Eigen::Ref<Eigen::MatrixXf> mean_errors,
                           Eigen::Ref<Eigen::VectorXd> log_deviation_errors);

}  // namespace torquewright::learning
