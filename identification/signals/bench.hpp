// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "actuator/motor/actuator.hpp"
#include "identification/log/log.hpp"
#include "identification/rig/rig.hpp"
#include "identification/signals/signals.hpp"

namespace torquewright::identification {

/// Which sides of the gearbox have their motion measured.
enum class Encoders {
  kOutput,
  kMotor,
  kBoth,  ///< Positions of both sides: the twist is known.
};

/// One joint of a log with its nominal actuator, and the sources of the two sides of its torque
/// balance (docs/derivations/identification.md section 1). It points to the rig and the actuators,
/// which have to outlive it.
struct Bench {
  const Rig* rig = nullptr;
  std::size_t joint = 0;                             ///< Index into Rig::joints.
  std::vector<const actuator::Actuator*> actuators;  ///< Actuators, one per joint.
  std::optional<Drive> drive;  ///< Source of the motor's torque; absent: the log does not tell it.
  /// Source of the load's torque; absent: the log does not tell it.
  std::optional<LoadSide> load_side;
  Quantity drive_channel = Quantity::kMotorCurrent;
  Quantity load_channel = Quantity::kOutputTorque;
  Encoders encoders = Encoders::kOutput;
  bool is_linear = false;  ///< The output is a linear axis, in m, m/s and N.
  bool has_temperature = false;
  /// Speed and acceleration are those of the logged velocity, though the same shaft's position was
  /// logged too: it tells them with less noise (tells_motion_better).
  bool moves_by_velocity = false;

  /// Actuator that moves in a gap without an encoder, where more is known than the nominal one.
  std::shared_ptr<const actuator::Actuator> in_gap;

  const actuator::Actuator& actuator() const { return *actuators[joint]; }
  const actuator::Actuator& actuator_in_gap() const { return in_gap ? *in_gap : actuator(); }
  /// Whether the drive's torque is made of the position by the law of the joint's controller: then
  /// the two are of one instant, whatever else is late.
  bool is_drive_by_law() const {
    return drive_channel == Quantity::kCommandedTorque && joint < rig->controllers.size() &&
           rig->controllers[joint].has_value();
  }
  bool has_torque_balance() const { return drive && load_side; }
};

/// Chooses the channels: current, then the driver's torque, then command, then voltage; a sensor
/// before the rig's model. The runs of a log hold the same channels; there is at least one run.
Bench make_bench(const Rig& rig, const Log& log, std::size_t joint,
                 const std::vector<const actuator::Actuator*>& actuators);

}  // namespace torquewright::identification
