// SPDX-License-Identifier: Apache-2.0
#include "learning/formulas/surrogate.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::learning {
namespace {

/// A ratio beyond e^20 says nothing more, and would become infinite.
constexpr double kGreatestLogRatio = 20.0;

/// Logarithm of the new probability density over the old one.
double log_ratio(const ActionSamples& samples, const Eigen::Ref<const Eigen::MatrixXf>& means,
                 const Eigen::Ref<const Eigen::VectorXd>& log_deviations, Eigen::Index sample) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < means.rows(); ++i) {
    const double action = samples.actions(i, sample);
    const double was =
        (action - samples.old_means(i, sample)) * std::exp(-samples.old_log_deviations(i));
    const double is = (action - means(i, sample)) * std::exp(-log_deviations(i));
    sum += 0.5 * (was * was - is * is) + samples.old_log_deviations(i) - log_deviations(i);
  }
  return sum;
}

double divergence(const ActionSamples& samples, const Eigen::Ref<const Eigen::MatrixXf>& means,
                  const Eigen::Ref<const Eigen::VectorXd>& log_deviations, Eigen::Index sample) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < means.rows(); ++i) {
    const double wider = log_deviations(i) - samples.old_log_deviations(i);
    const double moved =
        (means(i, sample) - samples.old_means(i, sample)) * std::exp(-log_deviations(i));
    sum += wider + 0.5 * (std::exp(-2.0 * wider) + moved * moved - 1.0);
  }
  return sum;
}

}  // namespace

SurrogateSums surrogate_of(const ActionSamples& samples,
                           const Eigen::Ref<const Eigen::MatrixXf>& means,
                           const Eigen::Ref<const Eigen::VectorXd>& log_deviations, double clip,
                           double weight, Eigen::Ref<Eigen::MatrixXf> mean_errors,
                           Eigen::Ref<Eigen::VectorXd> log_deviation_errors) {
  SurrogateSums sums;
  for (Eigen::Index j = 0; j < means.cols(); ++j) {
    const double advantage = samples.advantages(j);
    const double ratio =
        std::exp(std::min(log_ratio(samples, means, log_deviations, j), kGreatestLogRatio));
    const double clipped = std::clamp(ratio, 1.0 - clip, 1.0 + clip);
    const bool is_flat = clipped * advantage < ratio * advantage;
    sums.surrogate += std::min(ratio * advantage, clipped * advantage);
    sums.kl += divergence(samples, means, log_deviations, j);
    sums.clipped += is_flat ? 1.0 : 0.0;
    const double slope = is_flat ? 0.0 : -weight * ratio * advantage;
    for (Eigen::Index i = 0; i < means.rows(); ++i) {
      const double narrow = std::exp(-log_deviations(i));
      const double action = samples.actions(i, j);
      const double is = (action - means(i, j)) * narrow;
      mean_errors(i, j) = static_cast<float>(slope * is * narrow);
      log_deviation_errors(i) += slope * (is * is - 1.0);
    }
  }
  return sums;
}

}  // namespace torquewright::learning
