// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "identification/forward/candidate.hpp"
#include "identification/signals/bench.hpp"

namespace torquewright::identification {

/// One equation that a log's channels allow: what is measured less what a hypothesis says of it.
struct ForwardEquation {
  std::string quantity;  ///< Whose error it is.
  std::string unit;
  double unit_per_residual = 1.0;
  bool is_torque_balance = false;  ///< Of the drive's side and the load's.
  /// As the winding's voltage has it for certain, where the log holds it.
  std::optional<double> constant_factor_by_voltage;
  bool target_is_drive = false;  ///< The drive's channel is what is measured, and no coordinate.
  double used =
      0.0;  ///< Rms of what is predicted, in the residual's unit; 0: nothing to compare with.
  Hypothesis stated;
  std::vector<FitParameter> always;  ///< Fitted in every model: uncertain values, zero points.
  std::vector<double> always_start;  ///< Coordinates.
  std::function<void(std::span<const double>, Hypothesis&)> apply_always;
  std::vector<std::string> pointers;  ///< What the first of `always` are.
  std::vector<EffectCandidate> candidates;
  std::function<std::vector<double>(const Hypothesis&, const Signals&)> residual;
  std::function<std::vector<double>(const Signals&)> measured;  ///< In `unit`.
  /// Whether no law of nature speaks against it; empty: none is asked.
  std::function<bool(const Hypothesis&)> is_possible;
  /// Waves of the motor's or the output's angle that what a model leaves suggests.
  std::function<std::vector<EffectCandidate>(
      const std::function<std::vector<double>(const Signals&)>&)>
      waves;
};

}  // namespace torquewright::identification
