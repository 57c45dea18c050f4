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

/// Which sides of the train have their motion measured.
enum class Encoders {
  kOutput,
  kMotor,
  kBoth,  ///< Positions on both: the twist is known.
};

/// One joint of a log with its nominal actuator, and where the two sides of its torque balance come
/// from. docs/derivations/identification.md section 1. It points to the rig and the actuators,
/// which have to outlive it.
struct Bench {
  const Rig* rig = nullptr;
  std::size_t joint = 0;                             ///< Index into Rig::joints.
  std::vector<const actuator::Actuator*> actuators;  ///< One per joint.
  std::optional<Drive> drive;                        ///< Absent: nothing says what the motor does.
  std::optional<LoadSide> load_side;                 ///< Absent: nothing says what the load takes.
  Quantity drive_channel = Quantity::kMotorCurrent;
  Quantity load_channel = Quantity::kOutputTorque;
  Encoders encoders = Encoders::kOutput;
  bool is_linear = false;  ///< Output in m, m/s and N.
  bool has_temperature = false;

  /// What moves in a gap without an encoder, where more of it is known than the nominal actuator.
  std::shared_ptr<const actuator::Actuator> in_gap;

  const actuator::Actuator& actuator() const { return *actuators[joint]; }
  const actuator::Actuator& actuator_in_gap() const { return in_gap ? *in_gap : actuator(); }
  bool has_torque_balance() const { return drive && load_side; }
};

/// Chooses the channels: current, then the driver's torque, then command, then voltage; a sensor
/// before the rig's model. The runs of a log hold the same channels; there is at least one run.
Bench make_bench(const Rig& rig, const Log& log, std::size_t joint,
                 const std::vector<const actuator::Actuator*>& actuators);

}  // namespace torquewright::identification
