// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "identification/log/log.hpp"
#include "identification/rollout/free_values.hpp"

namespace torquewright::identification {

/// A value as rollouts on the training runs have it.
struct FittedValue {
  FreeValue which;
  double stated = 0.0;
  double value = 0.0;
  double standard_error = 0.0;  ///< Of the value, all others being as free.
  bool is_at_bound = false;     ///< Nothing is known but that it is not beyond.
  bool is_traded = false;       ///< Another value stands for it (trade_offs.hpp).

  /// Whether the motion says more of it than was known before; where nothing was, its error has to
  /// be less than itself, or than a change that shows.
  bool is_told() const;
};

struct ValueFit {
  RobotModel model;  ///< With the values.
  std::vector<FittedValue> values;
  double rms_before_rad = 0.0, rms_after_rad = 0.0;  ///< On the training runs.
  std::size_t rounds = 0;
  /// Squares that are left on the training runs, in rad^2, with what the values' distances from
  /// where they are known to be are worth; and what one of them is worth in squared standard
  /// errors.
  double cost = 0.0, weight = 0.0;
  /// (values x values) What the runs alone say of the values, and the inverse of that with what was
  /// known before.
  Eigen::MatrixXd information, covariance;
};

struct ValueFitOptions {
  std::size_t most_rounds = 8;
  double most_simulated_s = 60.0;  ///< Of the training runs, in one round of one set of values.
  /// Where the values begin, if not where they are stated.
  std::optional<RobotModel> begin;
  /// Only this limb is simulated, and only its values may be free; nothing: all.
  std::optional<std::size_t> limb = {};
  std::function<void(double share)> on_progress;
};

/// Moves the free values so that the robot under its own loops follows the runs that were not held
/// out: least squares of positions (output error) within the values' bounds, by steps of Levenberg
/// and Marquardt. Slopes are differences, each of the one limb that its value moves. Standard
/// errors count what is left as correlated over as many samples as it is. Without a training window
/// whose simulation is finite nothing moves and `values` is empty.
ValueFit fit_values(const Log& log, const RobotModel& stated, const std::vector<FreeValue>& free,
                    const ValueFitOptions& options = {});

}  // namespace torquewright::identification
