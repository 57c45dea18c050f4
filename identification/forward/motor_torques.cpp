// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/motor_torques.hpp"

#include <algorithm>
#include <iterator>

#include "identification/forward/drive_side.hpp"
#include "identification/forward/histories.hpp"
#include "identification/signals/signal.hpp"

namespace torquewright::identification {
namespace {

using actuator::Acts;
using actuator::Effect;

/// Factors of the torque constant, and what a winding's current follows.
bool acts_on_motor(const Effect& effect) {
  switch (effect.kind->acts) {
    case Acts::kTorqueFactor:
    case Acts::kFluxFactor:
    case Acts::kResistanceFactor:
    case Acts::kWindingVoltage:
    case Acts::kBusVoltage:
      return true;
    default:
      return false;
  }
}

}  // namespace

MotorTorques::MotorTorques(const Bench& bench, const Signals& signals, std::size_t most)
    : bench_(bench), signals_(signals), torques_(most), lags_(most) {}

std::shared_ptr<const MotorTorque> MotorTorques::of(const Hypothesis& hypothesis,
                                                    const MovedStretch& moved, double moved_s) {
  const LogErrors& log = hypothesis.log;
  const actuator::Actuator& actuator = hypothesis.actuator;
  const double channel_late_s = log.delay_s[static_cast<std::size_t>(bench_.drive_channel)];
  Key key{moved_s,
          channel_late_s + log.instant_s,
          hypothesis.winding_late_s,
          log.current_offset_A,
          log.positive_current_gain,
          log.negative_current_gain,
          actuator.motor,
          actuator.drive,
          actuator.transmission,
          {}};
  std::copy_if(actuator.effects.begin(), actuator.effects.end(), std::back_inserter(key.effects),
               acts_on_motor);
  return torques_.of(key, [&] { return computed(hypothesis, moved, key); });
}

MotorTorque MotorTorques::computed(Hypothesis hypothesis, const MovedStretch& moved,
                                   const Key& key) const {
  hypothesis.actuator.effects = key.effects;
  const std::size_t n = signals_.size();
  std::vector<double> channel(n);
  for (std::size_t i = 0; i < n; ++i) {
    channel[i] = bench_.drive == Drive::kVoltage ? signals_.voltage_V[i] : signals_.at[i].current_A;
  }
  if (key.drive_late_s != 0.0) channel = advanced(channel, key.drive_late_s, signals_.step_s);
  const DriveSide side(bench_, hypothesis, signals_, channel, moved.at(), key.drive_late_s);
  MotorTorque torque;
  torque.motor_Nm.reserve(n);
  torque.stated_over_own_slope.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    actuator::Instant at = moved.at()[i];
    torque.motor_Nm.push_back(side.motor_Nm(i, at));
    if (bench_.load_side != LoadSide::kSensor)
      torque.stated_over_own_slope.push_back(side.stated_over_own_slope(i, at));
  }
  return torque;
}

std::shared_ptr<const LawSeries> MotorTorques::lag(const Effect& effect,
                                                   const std::shared_ptr<const MotorTorque>& torque,
                                                   const MovedStretch& moved) {
  return lags_.of({effect, torque}, [&] {
    return lag_history_Nm(effect, moved.at(), torque->motor_Nm, signals_.step_s);
  });
}

}  // namespace torquewright::identification
