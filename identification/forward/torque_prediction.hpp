// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "identification/forward/hypothesis.hpp"
#include "identification/forward/motor_torques.hpp"
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
  /// All that the load's torque follows from; no loads where they are the bench's.
  struct LoadKey {
    double late_s;
    std::vector<Load> load;
    std::map<std::string, Load, std::less<>> loads;
    friend bool operator==(const LoadKey&, const LoadKey&) = default;
  };

  std::shared_ptr<const LawSeries> load_torque(const Hypothesis& hypothesis, double moved_s);
  LawSeries before_drag(const Hypothesis& hypothesis, MovedStretch& moved,
                        const std::shared_ptr<const MotorTorque>& motor);

  const Bench& bench_;
  const Signals& signals_;
  std::size_t most_;
  MotorTorques motor_torques_;
  Remembered<std::pair<double, double>, MovedStretch> moved_;  ///< By lateness and gear ratio.
  Remembered<LoadKey, LawSeries> loads_;
};

/// The same of one hypothesis alone.
std::vector<double> torque_balance_Nm(const Bench& bench, const Hypothesis& hypothesis,
                                      const Signals& signals);

}  // namespace torquewright::identification
