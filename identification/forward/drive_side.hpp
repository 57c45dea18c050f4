// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/forward/hypothesis.hpp"
#include "identification/forward/winding_current.hpp"

namespace torquewright::identification {

/// What the drive's channel makes of the motor under a hypothesis, sample by sample.
class DriveSide {
 public:
  /// `drive`: the channel in A or V at the samples `at`, moved forward by `late_s`. Keeps a
  /// reference to the hypothesis.
  DriveSide(const Bench& bench, const Hypothesis& hypothesis, const Signals& signals,
            const std::vector<double>& drive, const std::vector<actuator::Instant>& at,
            double late_s);

  /// The motor's torque at the output; sets the instant's current.
  double motor_Nm(std::size_t i, actuator::Instant& at) const;

  /// Where the drive's channel is what was measured, what is missing counts by what the stated
  /// actuator makes of a unit of it: else a fit could make everything small by a motor that yields
  /// little. By a difference; at least a twentieth of the stated one.
  double stated_over_own_slope(std::size_t i, actuator::Instant at) const;

 private:
  const actuator::Actuator& actuator_;
  bool is_voltage_;
  double stated_slope_ = 1.0, step_A_ = 1.0;
  Currents currents_;
};

}  // namespace torquewright::identification
