// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace torquewright::hopper {

/// What becomes of errors over one control period: e <- by_error e + by_drive u + by_unknown w,
/// where u is the feedback that acts and w what the document has wrong.
struct ErrorModel {
  Eigen::MatrixXd by_error;    ///< (2 n x 2 n), without what the ground or the place takes out
  Eigen::MatrixXd by_drive;    ///< (2 n x drives), per Nm
  Eigen::MatrixXd by_unknown;  ///< (2 n x p); of no columns where nothing is unknown.
};

/// What a controller does about errors and unknowns: u = -of_error e - of_unknown w.
struct Gains {
  Eigen::MatrixXd of_error;    ///< (drives x 2 n), Nm per error
  Eigen::MatrixXd of_unknown;  ///< (drives x p), Nm per unit
  /// The same for errors that the ground takes out while all points touch that are to, for when one
  /// of them does not; empty where none is to.
  Eigen::MatrixXd of_lifted;
};

/// Gains over a stretch of a motion in which the same points touch, evenly spaced.
struct GainStretch {
  double from_s = 0.0;
  double step_s = 0.0;
  std::vector<Gains> gains;        ///< Each holds from its time on.
  std::vector<ErrorModel> models;  ///< Beside each of the gains; empty: errors are not foretold.
  /// What a look at the end of each period tells of errors and unknowns (weighing.hpp); empty where
  /// the robot is not weighed.
  std::vector<Eigen::MatrixXd> weighing;
};

/// A period with a look at its end.
struct WeighedPeriod {
  const ErrorModel& model;
  const Eigen::MatrixXd& gain;
};

/// Gains by mode of the reference and time, and on after its end.
class GainSchedule {
 public:
  GainSchedule(std::vector<GainStretch> by_mode, Gains after_end, ErrorModel model_after,
               double ends_s);

  /// Returns the gains at a time in a mode of the reference; the nearest ones where the time is
  /// outside it.
  const Gains& at(std::size_t mode, double time_s) const;
  /// Returns the model there; null where errors are not foretold.
  const ErrorModel* model_at(std::size_t mode, double time_s) const;
  /// Returns the period of the mode that ends nearest to a time; none where no look is worth
  /// anything, after the motion's end too.
  std::optional<WeighedPeriod> weighed_before(std::size_t mode, double time_s) const;
  /// How many unknowns the gains know.
  Eigen::Index unknowns() const { return after_end_.of_unknown.cols(); }
  const std::vector<GainStretch>& by_mode() const { return by_mode_; }

 private:
  std::vector<GainStretch> by_mode_;
  Gains after_end_;
  ErrorModel model_after_;
  double ends_s_;
};

}  // namespace torquewright::hopper
