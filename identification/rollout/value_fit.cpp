// SPDX-License-Identifier: Apache-2.0
#include "identification/rollout/value_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "identification/rollout/output_errors.hpp"

namespace torquewright::identification {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kToldShare = 0.7;      ///< Of what was open before.
constexpr double kLeastFitGain = 1e-3;  ///< Relative, of the squares; less ends the rounds.
constexpr double kLeastPower = 1e-12;   ///< Of a value of which nothing is told.
constexpr double kFirstDamping = 1e-3, kMostDamping = 1e6;

class Fit {
 public:
  Fit(const Log& log, const RobotModel& stated, const std::vector<FreeValue>& free,
      const ValueFitOptions& options)
      : log_(log),
        free_(free),
        options_(options),
        windows_(fit_windows(log, options.most_simulated_s)),
        count_(static_cast<Index>(free.size())) {
    fit_.model = stated;
    stated_.resize(count_);
    bound_of_.assign(free.size(), 0.0);
    for (Index k = 0; k < count_; ++k) stated_[k] = value_in(stated, free[at(k)]);
  }

  ValueFit run() {
    VectorXd values = stated_;
    for (Index k = 0; options_.begin && k < count_; ++k)
      values[k] = value_in(*options_.begin, free_[at(k)]);
    std::vector<VectorXd> errors = errors_with(values);
    if (windows_.empty() || errors.empty()) return fit_;
    set_weights(errors);
    fit_.rms_before_rad = rms(errors);
    double damping = kFirstDamping;
    for (; fit_.rounds < options_.most_rounds; ++fit_.rounds) {
      if (options_.on_progress) {
        options_.on_progress(static_cast<double>(fit_.rounds) /
                             static_cast<double>(options_.most_rounds));
      }
      if (!find_slopes(values, errors)) break;
      const double before = cost(errors, values);
      bool is_better = false;
      for (; damping < kMostDamping && !is_better; damping *= is_better ? 0.1 : 10.0) {
        const VectorXd tried = step_from(values, damping);
        std::vector<VectorXd> then = errors_with(tried);
        is_better = !then.empty() && cost(then, tried) < before;
        if (is_better) values = tried, errors = std::move(then);
      }
      const double gained = before - cost(errors, values);
      if (!is_better || gained < kLeastFitGain * before) break;
      set_weights(errors);
    }
    finish(values, errors);
    return fit_;
  }

 private:
  static std::size_t at(Index k) { return static_cast<std::size_t>(k); }

  /// Of a limb that is simulated, among all.
  std::size_t place_of(std::size_t l) const { return options_.limb.value_or(l); }

  bool is_in(const Limb& limb, const FreeValue& value) const {
    return std::any_of(limb.joints.begin(), limb.joints.end(),
                       [&](std::size_t joint) { return value.is_of(joint); });
  }

  RobotModel with(const VectorXd& values) const {
    RobotModel model = fit_.model;
    for (Index k = 0; k < count_; ++k) set_value(model, free_[at(k)], values[k]);
    return model;
  }

  /// Limb by limb; empty where one diverges.
  std::vector<VectorXd> errors_with(const VectorXd& values) {
    const RobotModel model = with(values);
    limbs_ = limbs_of(model.load);
    if (options_.limb) limbs_ = {limbs_[*options_.limb]};
    std::vector<VectorXd> errors;
    for (const Limb& limb : limbs_) {
      errors.push_back(output_errors_rad(log_, model, limb, windows_));
      if (errors.back().size() == 0) return {};
    }
    return errors;
  }

  double squares(const std::vector<VectorXd>& errors) const {
    double sum = 0.0;
    for (const VectorXd& each : errors) sum += each.squaredNorm();
    return sum;
  }

  double rms(const std::vector<VectorXd>& errors) const {
    double count = 0.0;
    for (const VectorXd& each : errors) count += static_cast<double>(each.size());
    return std::sqrt(squares(errors) / count);
  }

  void set_weights(const std::vector<VectorXd>& errors) {
    weight_ = weight_of(errors, limbs_, windows_);
  }

  double prior(Index k) const {
    const double deviation = free_[at(k)].deviation;
    return std::isfinite(deviation) ? 1.0 / (deviation * deviation) : 0.0;
  }

  double cost(const std::vector<VectorXd>& errors, const VectorXd& values) const {
    double sum = weight_ * squares(errors);
    for (Index k = 0; k < count_; ++k) {
      const double off = values[k] - stated_[k];
      sum += prior(k) * off * off;
    }
    return sum;
  }

  /// Power and descent of the squares, in the values' sizes.
  bool find_slopes(const VectorXd& values, const std::vector<VectorXd>& errors) {
    power_ = MatrixXd::Zero(count_, count_);
    descent_ = VectorXd::Zero(count_);
    const RobotModel model = with(values);
    for (std::size_t l = 0; l < limbs_.size(); ++l) {
      std::vector<Index> own;
      std::vector<FreeValue> own_values;
      for (Index k = 0; k < count_; ++k) {
        if (!is_in(limbs_[l], free_[at(k)])) continue;
        own.push_back(k);
        own_values.push_back(free_[at(k)]);
      }
      const MatrixXd slopes = slopes_of(log_, model, own_values, place_of(l), windows_, errors[l]);
      if (slopes.cols() != static_cast<Index>(own.size())) return false;
      const MatrixXd products = slopes.transpose() * slopes;
      const VectorXd right = slopes.transpose() * errors[l];
      for (std::size_t a = 0; a < own.size(); ++a) {
        descent_[own[a]] += right[static_cast<Index>(a)];
        for (std::size_t b = 0; b < own.size(); ++b) {
          power_(own[a], own[b]) += products(static_cast<Index>(a), static_cast<Index>(b));
        }
      }
    }
    return true;
  }

  /// Those at a bound that pushes them further stay.
  VectorXd step_from(const VectorXd& values, double damping) const {
    VectorXd then = values;
    std::vector<bool> fixed(free_.size(), false);
    for (int round = 0; round < 20; ++round) {
      const VectorXd move = solve(values, damping, fixed);
      bool is_cut = false;
      then = values;
      for (Index k = 0; k < count_; ++k) {
        const FreeValue& which = free_[at(k)];
        if (fixed[at(k)]) {
          then[k] = bound_of_[at(k)];
          continue;
        }
        then[k] = values[k] + which.size * move[k];
        if (then[k] < which.lowest || then[k] > which.highest) {
          bound_of_[at(k)] = std::clamp(then[k], which.lowest, which.highest);
          fixed[at(k)] = is_cut = true;
        }
      }
      if (!is_cut) break;
    }
    return then;
  }

  VectorXd solve(const VectorXd& values, double damping, const std::vector<bool>& fixed) const {
    MatrixXd power = weight_ * power_;
    VectorXd right = -weight_ * descent_;
    for (Index k = 0; k < count_; ++k) {
      const double size = free_[at(k)].size;
      power(k, k) += prior(k) * size * size;
      right[k] -= prior(k) * size * (values[k] - stated_[k]);
      power(k, k) *= 1.0 + damping;
      power(k, k) += 1e-9 * (1.0 + power(k, k));
    }
    for (Index k = 0; k < count_; ++k) {
      if (!fixed[at(k)]) continue;
      const double move = (bound_of_[at(k)] - values[k]) / free_[at(k)].size;
      right -= move * power.col(k);
      power.row(k).setZero();
      power.col(k).setZero();
      power(k, k) = 1.0;
      right[k] = move;
    }
    return power.ldlt().solve(right);
  }

  void finish(const VectorXd& values, const std::vector<VectorXd>& errors) {
    fit_.model = with(values);
    fit_.rms_after_rad = rms(errors);
    fit_.weight = weight_;
    fit_.cost = cost(errors, values) / weight_;
    if (!find_slopes(values, errors)) return;
    VectorXd sizes(count_);
    for (Index k = 0; k < count_; ++k) sizes[k] = free_[at(k)].size;
    MatrixXd power = weight_ * power_;
    const VectorXd smaller = sizes.cwiseInverse();
    fit_.information = smaller.asDiagonal() * power * smaller.asDiagonal();
    for (Index k = 0; k < count_; ++k) power(k, k) += prior(k) * sizes[k] * sizes[k] + kLeastPower;
    const MatrixXd spread = power.ldlt().solve(MatrixXd::Identity(count_, count_));
    fit_.covariance = sizes.asDiagonal() * spread * sizes.asDiagonal();
    for (Index k = 0; k < count_; ++k) {
      const FreeValue& which = free_[at(k)];
      FittedValue value{which, stated_[k], values[k], std::sqrt(fit_.covariance(k, k)),
                        false, false};
      value.is_at_bound = values[k] <= which.lowest || values[k] >= which.highest;
      fit_.values.push_back(value);
    }
  }

  const Log& log_;
  const std::vector<FreeValue>& free_;
  const ValueFitOptions& options_;
  std::vector<Window> windows_;
  std::vector<Limb> limbs_;
  Index count_ = 0;
  VectorXd stated_;
  double weight_ = 1.0;
  MatrixXd power_;
  VectorXd descent_;
  mutable std::vector<double> bound_of_;
  ValueFit fit_;
};

}  // namespace

bool FittedValue::is_told() const {
  const bool is_bounded = std::isfinite(which.deviation);
  const double most =
      is_bounded ? kToldShare * which.deviation : std::max(std::abs(value), which.size);
  return !is_at_bound && !is_traded && standard_error < most;
}

ValueFit fit_values(const Log& log, const RobotModel& stated, const std::vector<FreeValue>& free,
                    const ValueFitOptions& options) {
  return Fit(log, stated, free, options).run();
}

}  // namespace torquewright::identification
