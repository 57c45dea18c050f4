// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/weighing.hpp"

#include <Eigen/Cholesky>

namespace torquewright::hopper {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

double squared(double number) { return number * number; }

/// Variances of a look (2 n x 1).
VectorXd look_variances(Index n, Index places, const WeighingOptions& options) {
  VectorXd variances(2 * n);
  variances.head(n).setConstant(squared(options.angle_rad));
  variances.head(places).setConstant(squared(options.place_m));
  variances.tail(n).setConstant(squared(options.rate_rad_s));
  variances.segment(n, places).setConstant(squared(options.speed_m_s));
  return variances;
}

}  // namespace

WeighingGains::WeighingGains(Index errors, const VectorXd& spread, Index places,
                             const WeighingOptions& options)
    : looked_(look_variances(errors / 2, places, options)), options_(options) {
  const Index size = errors + spread.size();
  variance_.setZero(size, size);
  variance_.bottomRightCorner(spread.size(), spread.size()) = spread.cwiseAbs2().asDiagonal();
}

std::vector<MatrixXd> WeighingGains::over(const std::vector<ErrorModel>& models, double period_s) {
  std::vector<MatrixXd> gains;
  const Index errors = looked_.size(), size = variance_.rows();
  // A torque that stays for a while disturbs as white noise of that density does.
  const double torque = squared(options_.torque_Nm) * 2.0 * options_.torque_time_s / period_s;
  MatrixXd carry = MatrixXd::Identity(size, size);
  for (const ErrorModel& model : models) {
    carry.topLeftCorner(errors, errors) = model.by_error;
    carry.topRightCorner(errors, size - errors) = model.by_unknown;
    variance_ = (carry * variance_ * carry.transpose()).eval();
    variance_.topLeftCorner(errors, errors) += torque * model.by_drive * model.by_drive.transpose();
    MatrixXd seen = variance_.topLeftCorner(errors, errors);
    seen.diagonal() += looked_;
    const MatrixXd gain = seen.llt().solve(variance_.topRows(errors)).transpose();
    variance_ -= (gain * variance_.topRows(errors)).eval();
    variance_ = (0.5 * (variance_ + variance_.transpose())).eval();
    gains.push_back(gain);
  }
  return gains;
}

void Weighing::start(Index errors, Index unknowns) {
  error_.setZero(errors);
  unknown_.setZero(unknowns);
}

void Weighing::look(const ErrorModel& model, const MatrixXd& gain, const VectorXd& feedback_Nm,
                    const VectorXd& error) {
  error_ =
      (model.by_error * error_ + model.by_drive * feedback_Nm + model.by_unknown * unknown_).eval();
  innovation_ = error - error_;
  error_ += gain.topRows(error_.size()) * innovation_;
  unknown_ += gain.bottomRows(unknown_.size()) * innovation_;
}

}  // namespace torquewright::hopper
