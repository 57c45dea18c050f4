// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/forward/hypothesis.hpp"
#include "identification/forward/winding_current.hpp"

namespace torquewright::identification {

/// Computes the motor's torque from the drive's channel under a hypothesis, sample by sample.
class DriveSide {
 public:
  /// `drive` is the channel in A or V at the samples `at`, moved forward by `late_s`. Keeps a
  /// reference to the hypothesis.
  DriveSide(const Bench& bench, const Hypothesis& hypothesis, const Signals& signals,
            const std::vector<double>& drive, const std::vector<actuator::Instant>& at,
            double late_s);

  /// Motor torque at the output, in Nm; sets the current of `at`.
  double motor_Nm(std::size_t i, actuator::Instant& at) const;

  /// Slope of torque over the drive's channel as stated, over that of the hypothesis, by a
  /// difference; at least 1/20. Where the drive's channel is what was measured, residuals are
  /// multiplied by it, so that no fit makes them small by a motor that yields little.
  double stated_over_own_slope(std::size_t i, actuator::Instant at) const;

 private:
  const actuator::Actuator& actuator_;
  bool is_voltage_;
  double stated_slope_ = 1.0, step_A_ = 1.0;
  Currents currents_;
};

}  // namespace torquewright::identification
