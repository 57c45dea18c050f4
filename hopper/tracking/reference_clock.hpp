// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/tracking/reference.hpp"

namespace torquewright::hopper {

/// How a controller's place in the motion follows the ground instead of the clock.
/// docs/derivations/tracking.md, "Clock".
struct ClockOptions {
  /// A point that a planned impact is to bring down touches earlier: the clock jumps to the impact.
  /// Later: it waits in front of it.
  bool resynchronise = true;
  /// A touch earlier than this before the impact is a stumble, no landing: the clock does not jump.
  double earliest_s = 0.1;
  double longest_wait_s = 0.05;  ///< After this time of waiting the motion goes on without contact.
};

/// A time in a reference.
struct ClockReading {
  double time_s = 0.0;    ///< Time in the motion; just before an impact while that is waited for.
  double waited_s = 0.0;  ///< Time for which that impact was waited for.
};

/// Tells a controller where in the motion it is. The reference must outlive it.
class ReferenceClock {
 public:
  ReferenceClock(const Reference& reference, const ClockOptions& options);

  void start();
  /// Returns the place in the motion. `time_s` never runs backwards between two starts.
  ClockReading read(double time_s, const TouchingPoints& touches);

 private:
  bool lands(std::size_t mode, const TouchingPoints& touches) const;

  const Reference* reference_;
  ClockOptions options_;
  std::size_t mode_ = 0;   ///< The mode that has begun.
  double behind_s_ = 0.0;  ///< How far the motion is behind time; negative: ahead.
};

/// Returns the state and torques at that place: while an impact is waited for, the motion before it
/// goes on at constant acceleration.
void instant_at(const Reference& reference, const dynamics::Tree& tree, const ClockReading& reading,
                ReferenceInstant& out);

/// Returns the motion's own torques (drives x 1), as the mean of the time in which they will act:
/// from latency_s on for hold_s, but not those of after an impact that is still to come.
Eigen::VectorXd fed_forward_Nm(const Reference& reference, const ClockReading& reading,
                               double latency_s, double hold_s);

}  // namespace torquewright::hopper
