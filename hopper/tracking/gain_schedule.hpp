// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace torquewright::hopper {

/// What becomes of errors over one control period: e <- by_error e + by_drive u, where u is the
/// feedback that acts.
struct ErrorModel {
  Eigen::MatrixXd by_error;  ///< (2 n x 2 n), without what the ground or the place takes out
  Eigen::MatrixXd by_drive;  ///< (2 n x drives), per Nm
};

/// Gains over a stretch of a motion in which the same points touch, evenly spaced.
struct GainStretch {
  double from_s = 0.0;
  double step_s = 0.0;
  /// (drives x 2 n), Nm per error; each holds from its time on.
  std::vector<Eigen::MatrixXd> gains;
  std::vector<ErrorModel> models;  ///< Beside each of the gains; empty: errors are not foretold.
};

/// Gains by mode of the reference and time, and on after its end.
class GainSchedule {
 public:
  GainSchedule(std::vector<GainStretch> by_mode, Eigen::MatrixXd after_end, ErrorModel model_after,
               double ends_s);

  /// Returns the gains at a time in a mode of the reference; the nearest ones where the time is
  /// outside it.
  const Eigen::MatrixXd& at(std::size_t mode, double time_s) const;
  /// Returns the model there; null where errors are not foretold.
  const ErrorModel* model_at(std::size_t mode, double time_s) const;
  const std::vector<GainStretch>& by_mode() const { return by_mode_; }

 private:
  std::vector<GainStretch> by_mode_;
  Eigen::MatrixXd after_end_;
  ErrorModel model_after_;
  double ends_s_;
};

}  // namespace torquewright::hopper
