// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "hopper/tracking/gain_schedule.hpp"

namespace torquewright::hopper {

/// What a controller takes its looks and its model to be worth; standard deviations.
struct WeighingOptions {
  double place_m = 0.01;    ///< Of a look's place of the base,
  double angle_rad = 0.02;  ///< its attitude and joints (m where prismatic),
  double speed_m_s = 0.05;  ///< the base's velocity,
  double rate_rad_s = 0.2;  ///< and all other rates.
  /// Of what a drive does beside the model: feedback of some 3 Nm, with gains that are a tenth off,
  double torque_Nm = 0.3;
  double torque_time_s = 0.05;  ///< which stays for about so long.
};

/// Gains with which errors (2 n x 1) beside the model's tell of errors and unknowns ((2 n + p) x 2
/// n each), for every period of a motion that begins as planned: Kalman's.
/// docs/derivations/tracking.md eq. (18).
class WeighingGains {
 public:
  /// `spread`: standard deviations of the unknowns (p x 1); of the 2 n `errors` the first `places`
  /// are lengths.
  WeighingGains(Eigen::Index errors, const Eigen::VectorXd& spread, Eigen::Index places,
                const WeighingOptions& options = {});
  /// Returns those of the next stretch, which begins where the last one ended.
  std::vector<Eigen::MatrixXd> over(const std::vector<ErrorModel>& models, double period_s);

 private:
  Eigen::VectorXd looked_;    ///< Variances of a look.
  Eigen::MatrixXd variance_;  ///< Of errors and unknowns.
  WeighingOptions options_;
};

/// Weighs a robot while it stands.
class Weighing {
 public:
  void start(Eigen::Index errors, Eigen::Index unknowns);
  /// Carries on by a period in which the feedback acted, and takes a look.
  void look(const ErrorModel& model, const Eigen::MatrixXd& gain,
            const Eigen::VectorXd& feedback_Nm, const Eigen::VectorXd& error);
  const Eigen::VectorXd& unknown() const { return unknown_; }

 private:
  Eigen::VectorXd error_, unknown_, innovation_;
};

}  // namespace torquewright::hopper
