// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "identification/forward/hypothesis.hpp"
#include "identification/forward/moved_stretch.hpp"
#include "identification/forward/remembered.hpp"
#include "identification/signals/bench.hpp"

namespace torquewright::identification {

/// The residual of a stretch's torque balance under one hypothesis after another, in Nm at the
/// output (N on a linear axis). The laws of actuator/ are applied in order: drive channel ->
/// current -> torque with its laws and lag -> less the rotor's inertia and drag -> mesh -> ripple.
/// With a torque sensor the residual is what it measured less that; with the rig's model as the
/// load it is what the load needs of the motor less what the motor gives. Either way torque that is
/// missing on the output has its own sign. Where a sample stands for a time in which the motion
/// reverses, both directions count by their shares (docs/derivations/identification.md section 12).
/// What a hypothesis has in common with the last ones is remembered, and changes no bit of a
/// residual.
class TorqueBalance {
 public:
  /// Keeps references to both. `most`: series that are remembered, of each kind.
  TorqueBalance(const Bench& bench, const Signals& signals, std::size_t most);

  std::vector<double> residual_Nm(const Hypothesis& hypothesis);

 private:
  /// All that the motor's torque follows from.
  struct DriveKey {
    double moved_s, drive_late_s, winding_late_s;
    double current_offset_A, positive_current_gain, negative_current_gain;
    actuator::Motor motor;
    actuator::Drive drive;
    actuator::Transmission transmission;
    std::vector<actuator::Effect> effects;
    friend bool operator==(const DriveKey&, const DriveKey&) = default;
  };
  struct DriveTorque {
    LawSeries motor_Nm;
    LawSeries stated_over_own_slope;  ///< Empty beside a sensor.
  };
  /// What a lag of the motor's torque follows from, which stays as long as the key.
  using LagKey = std::pair<actuator::Effect, std::shared_ptr<const DriveTorque>>;
  /// All that the load's torque follows from; no loads where they are the bench's.
  struct LoadKey {
    double late_s;
    std::vector<Load> load;
    std::map<std::string, Load, std::less<>> loads;
    friend bool operator==(const LoadKey&, const LoadKey&) = default;
  };
  class Ripples;
  struct Terms;

  DriveTorque drive_torque(const Hypothesis& hypothesis, const MovedStretch& moved,
                           double drive_late_s) const;
  LawSeries load_torque(const Hypothesis& hypothesis, double late_s, bool is_as_stated) const;
  double load_late_s(const Hypothesis& hypothesis, double moved_s) const;
  Terms terms(const Hypothesis& hypothesis);
  LawSeries histories(const actuator::Actuator& actuator, MovedStretch& moved,
                      const std::shared_ptr<const DriveTorque>& drive);

  const Bench& bench_;
  const Signals& signals_;
  std::size_t most_;
  Remembered<std::pair<double, double>, MovedStretch> moved_;
  Remembered<DriveKey, DriveTorque> drives_;
  Remembered<LoadKey, LawSeries> loads_;
  Remembered<LagKey, LawSeries> lags_;
};

/// The same of one hypothesis alone.
std::vector<double> torque_balance_Nm(const Bench& bench, const Hypothesis& hypothesis,
                                      const Signals& signals);

}  // namespace torquewright::identification
