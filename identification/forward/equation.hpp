// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "identification/forward/candidate.hpp"
#include "identification/signals/bench.hpp"

namespace torquewright::identification {

/// The residual of one of some stretches under a hypothesis.
using ResidualOfStretch =
    std::function<std::vector<double>(const Hypothesis&, std::size_t stretch)>;

/// One equation that a log's channels allow: the measured quantity less what a hypothesis predicts.
struct ForwardEquation {
  std::string quantity;  ///< Quantity whose error the residual is.
  std::string unit;
  double unit_per_residual = 1.0;
  bool is_torque_balance = false;  ///< It is the balance of the drive's and the load's torque.
  /// Factor on the torque constant that the winding's voltage shows for certain, where it is
  /// logged.
  std::optional<double> constant_factor_by_voltage;
  /// The drive's channel is what is measured, so it is no coordinate.
  bool target_is_drive = false;
  double used =
      0.0;  ///< Rms of what is predicted, in the residual's unit; 0: nothing to compare with.
  Hypothesis stated;
  std::vector<FitParameter> always;  ///< Fitted in every model: uncertain values and zero points.
  std::vector<double> always_start;  ///< Coordinates at which fits of `always` start.
  std::function<void(std::span<const double>, Hypothesis&)> apply_always;
  /// Pointers into the documents of the first entries of `always`.
  std::vector<std::string> pointers;
  std::vector<EffectCandidate> candidates;
  std::function<std::vector<double>(const Hypothesis&, const Signals&)> residual;
  /// Returns the same function on stretches that outlive it, for many hypotheses: it remembers what
  /// they share. For one thread. Empty: `residual` is all there is.
  std::function<ResidualOfStretch(const std::vector<Signals>&)> residual_on;
  /// Returns the measured quantity, in `unit`.
  std::function<std::vector<double>(const Signals&)> measured;
  /// Returns whether a hypothesis breaks no law of nature; empty: not asked.
  std::function<bool(const Hypothesis&)> is_possible;
  /// Returns waves of the motor's or the output's angle that a model's residual suggests.
  std::function<std::vector<EffectCandidate>(
      const std::function<std::vector<double>(const Signals&)>&)>
      waves;
};

}  // namespace torquewright::identification
