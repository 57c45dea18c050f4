// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace torquewright::hopper {

/// Gains over a stretch of a motion in which the same points touch, evenly spaced.
struct GainStretch {
  double from_s = 0.0;
  double step_s = 0.0;
  /// (drives x 2 n), Nm per error; each holds from its time on.
  std::vector<Eigen::MatrixXd> gains;
};

/// Gains by mode of the reference and time, and on after its end.
class GainSchedule {
 public:
  GainSchedule(std::vector<GainStretch> by_mode, Eigen::MatrixXd after_end, double ends_s);

  /// Returns the gains at a time in a mode of the reference; the nearest ones where the time is
  /// outside it.
  const Eigen::MatrixXd& at(std::size_t mode, double time_s) const;
  const std::vector<GainStretch>& by_mode() const { return by_mode_; }

 private:
  std::vector<GainStretch> by_mode_;
  Eigen::MatrixXd after_end_;
  double ends_s_;
};

}  // namespace torquewright::hopper
