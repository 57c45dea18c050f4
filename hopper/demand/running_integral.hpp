// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace torquewright::hopper {

/// Integrals over time of signals that are linear between samples, and of impulses at some of them.
/// Rows are signals.
class RunningIntegral {
 public:
  /// Integrates signals that have as many columns as there are times, which do not descend.
  /// Requires at least one.
  RunningIntegral(const std::vector<double>& times_s, const Eigen::MatrixXd& signals);

  /// Adds an impulse. Impulses must come in the order of their samples, before the first call of
  /// over().
  void add_impulse(Eigen::Index sample, const Eigen::VectorXd& impulse);

  /// Returns the integral from a sample's time, with its impulse, over the duration (or to the last
  /// sample).
  Eigen::VectorXd over(Eigen::Index from_sample, double duration_s) const;

 private:
  Eigen::VectorXd until(double time_s) const;

  const std::vector<double>& times_s_;
  const Eigen::MatrixXd& signals_;
  Eigen::MatrixXd before_;  ///< Integral up to a sample, without its own impulse.
  Eigen::MatrixXd impulse_;
};

}  // namespace torquewright::hopper
