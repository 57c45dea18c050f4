// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "identification/forward/hypothesis.hpp"
#include "identification/forward/moved_stretch.hpp"
#include "identification/forward/remembered.hpp"
#include "identification/signals/bench.hpp"

namespace torquewright::identification {

/// Torque of the motor through a stretch, at the output.
struct MotorTorque {
  LawSeries motor_Nm;
  /// Slope of torque over the drive's channel as stated over the hypothesis' own (DriveSide); empty
  /// beside a torque sensor.
  LawSeries stated_over_own_slope;
};

/// The motor's torque in a stretch under one hypothesis after another, and lags of it; those of the
/// last hypotheses are remembered.
class MotorTorques {
 public:
  /// Keeps references to both.
  MotorTorques(const Bench& bench, const Signals& signals, std::size_t most);

  /// `moved`: as the hypothesis has the motion, which is late by `moved_s`.
  std::shared_ptr<const MotorTorque> of(const Hypothesis& hypothesis, const MovedStretch& moved,
                                        double moved_s);
  /// What a lag adds to a torque that was returned.
  std::shared_ptr<const LawSeries> lag(const actuator::Effect& effect,
                                       const std::shared_ptr<const MotorTorque>& torque,
                                       const MovedStretch& moved);

 private:
  /// All that the motor's torque follows from.
  struct Key {
    double moved_s, drive_late_s, winding_late_s;
    double current_offset_A, positive_current_gain, negative_current_gain;
    actuator::Motor motor;
    actuator::Drive drive;
    actuator::Transmission transmission;
    std::vector<actuator::Effect> effects;
    friend bool operator==(const Key&, const Key&) = default;
  };
  /// What is lagged stays as long as it is known by its place.
  using LagKey = std::pair<actuator::Effect, std::shared_ptr<const MotorTorque>>;

  MotorTorque computed(Hypothesis hypothesis, const MovedStretch& moved, const Key& key) const;

  const Bench& bench_;
  const Signals& signals_;
  Remembered<Key, MotorTorque> torques_;
  Remembered<LagKey, LawSeries> lags_;
};

}  // namespace torquewright::identification
