// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "actuator/effects/effect.hpp"
#include "identification/forward/remembered.hpp"
#include "identification/signals/signal.hpp"
#include "identification/signals/signals.hpp"

namespace torquewright::identification {

/// Values of one law at every sample of a stretch.
using LawSeries = std::vector<double>;

/// The same while it turns forward and backward; 0 in a direction that a sample has no share of.
struct DirectedSeries {
  LawSeries forward, backward;
};

/// The motion of a stretch as it was before its channels were late, and what laws that follow it
/// alone make of it. Most hypotheses of a search differ in one effect: series of the others are
/// remembered. Waves are as large as the signals' low-pass leaves them, and nothing where they turn
/// so fast that they would fold.
class MovedStretch {
 public:
  /// `ratio`: of the transmission, with which waves of the motor turn; `most`: series that are
  /// remembered, of each kind.
  MovedStretch(const Signals& signals, double late_s, double ratio, std::size_t most);

  /// Directions are those that have passed the channels' low-pass, where they are known.
  const std::vector<actuator::Instant>& at() const { return at_; }
  const LawSeries& rotor_rad_s2() const { return rotor_rad_s2_; }  ///< Over the ratio.
  /// Shares of the samples' times in which it turns forward.
  const LawSeries& forward_shares() const { return forward_shares_; }

  std::shared_ptr<const DirectedSeries> drag(const actuator::Effect& effect);
  /// Of an effect at the output, under a load of 1 Nm.
  std::shared_ptr<const LawSeries> ripple(const actuator::Effect& effect);
  /// Of an effect that follows neither direction nor load.
  std::shared_ptr<const LawSeries> plain(const actuator::Effect& effect);
  /// Of a friction that has a history; see friction_history_Nm().
  std::shared_ptr<const LawSeries> friction_history(const actuator::Effect& effect);

 private:
  /// Calls `law` with the effect as it is seen at each sample, and the sample.
  template <typename Law>
  void at_every_sample(const actuator::Effect& effect, const Law& law);
  LawSeries gains_of_waves(double turns_per_rad) const;
  const LawSeries& speeds_of_parts_rad_s();

  double step_s_, cutoff_Hz_, ratio_;
  std::optional<LowPass> filter_;
  std::vector<actuator::Instant> at_;
  LawSeries rotor_rad_s2_, forward_shares_;
  std::optional<LawSeries> speeds_of_parts_rad_s_;
  Remembered<actuator::Effect, DirectedSeries> drags_;
  Remembered<actuator::Effect, LawSeries> ripples_, plains_, histories_;
  Remembered<double, LawSeries> gains_;
};

}  // namespace torquewright::identification
