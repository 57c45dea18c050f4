// SPDX-License-Identifier: Apache-2.0
#include "identification/signals/bench.hpp"

namespace torquewright::identification {
namespace {

void choose_drive(const Channels& channels, Bench& bench) {
  const auto take = [&](Drive drive, Quantity quantity) {
    if (bench.drive || !channels.has(quantity)) return;
    bench.drive = drive;
    bench.drive_channel = quantity;
  };
  take(Drive::kCurrent, Quantity::kMotorCurrent);
  take(Drive::kTorque, Quantity::kReportedTorque);
  take(Drive::kTorque, Quantity::kCommandedTorque);
  take(Drive::kVoltage, Quantity::kWindingVoltage);
  take(Drive::kVoltage, Quantity::kDuty);
}

void choose_load_side(const Channels& channels, Bench& bench) {
  for (const Quantity sensor : {Quantity::kOutputTorque, Quantity::kLinearForce}) {
    if (!channels.has(sensor)) continue;
    bench.load_side = LoadSide::kSensor;
    bench.load_channel = sensor;
  }
  if (!bench.load_side && bench.rig->load.type != LoadType::kDynamometer) {
    bench.load_side = LoadSide::kModel;
  }
}

/// Its load says so, or, on a dynamometer, its sensors.
bool is_linear(const Channels& channels, const Load& load) {
  if (load.type != LoadType::kDynamometer) return load.type == LoadType::kLinearAxis;
  return channels.has(Quantity::kLinearPosition) || channels.has(Quantity::kLinearVelocity);
}

/// As the output's motion is read: a position before a velocity, the output's before the motor's.
Encoders encoders_of(const Channels& channels) {
  const auto any = [&](Quantity first, Quantity second) {
    return channels.has(first) || channels.has(second);
  };
  const bool output = any(Quantity::kOutputPosition, Quantity::kLinearPosition);
  const bool motor = channels.has(Quantity::kMotorPosition);
  if (output && motor) return Encoders::kBoth;
  if (output || motor) return output ? Encoders::kOutput : Encoders::kMotor;
  const bool output_velocity = any(Quantity::kOutputVelocity, Quantity::kLinearVelocity);
  return output_velocity ? Encoders::kOutput : Encoders::kMotor;
}

}  // namespace

Bench make_bench(const Rig& rig, const Log& log, std::size_t joint,
                 const std::vector<const actuator::Actuator*>& actuators) {
  Bench bench;
  bench.rig = &rig;
  bench.joint = joint;
  bench.actuators = actuators;
  const Channels& channels = log.runs.front().joints[joint];
  bench.is_linear = is_linear(channels, rig.load);
  choose_drive(channels, bench);
  choose_load_side(channels, bench);
  bench.encoders = encoders_of(channels);
  bench.has_temperature =
      channels.has(Quantity::kWindingTemperature) || channels.has(Quantity::kCaseTemperature);
  return bench;
}

}  // namespace torquewright::identification
