// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace torquewright::actuator {

/// The channels and drives without which no balance of torques shows an effect.
struct Needs {
  bool winding_temperature = false;  ///< A logged winding temperature.
  bool winding_voltage = false;      ///< A drive that is known by its winding's voltage.
  bool duty = false;                 ///< A drive that is known by its duty cycle.
};

/// The error of a rig or a log that an effect looks like in a balance of torques. Two that look
/// alike there cannot be told apart, whatever is played, on a bench that measures nothing else
/// (docs/derivations/identification.md).
enum class StandsFor {
  kItself,       ///< Nothing of a rig or of a log looks like it.
  kOffset,       ///< A constant torque: the offset of a torque or a current channel.
  kTorqueScale,  ///< A factor on all torques of the motor: a load that is off by that factor.
  kLoadInertia,  ///< A torque in proportion to the acceleration: an inertia of the load.
  kSensorLag,    ///< A motor's torque that comes late: a torque sensor that responds late.
};

/// The torque that a friction holds while the output rests.
enum class AtRest {
  kNothing,    ///< It holds no torque of its own.
  kLevel,      ///< It holds up to the torque that it has in motion, the same in both directions.
  kBreakaway,  ///< It holds more than it has in motion, the same in both directions.
  kOwnLaw,     ///< What it holds depends on the direction, or on where the motion began.
};

/// The part of an elastic train, between motor and output, that an effect is.
enum class TrainPart {
  kNone,        ///< It acts on one side of the train.
  kGap,         ///< Within it the train carries nothing.
  kSpring,      ///< It carries torque by its twist, and gives it back.
  kHysteresis,  ///< It carries torque beside a spring, by the history of the twist.
};

/// How often an effect occurs: whether an experiment is planned for it where no effect is asked
/// for.
enum class Presence {
  kSome,   ///< Only where it is asked for by name.
  kMost,   ///< In most actuators.
  kEvery,  ///< In every joint: fitted along, asked for or not.
};

/// A motion that shows an effect apart from others.
struct Excitation {
  /// Rank: of several effects the one with the lowest rank is played first, as the most peculiar.
  int rank = 0;
  std::string_view sentence;  ///< A sentence on what to play, or to measure besides.
};

/// A torque constant that falls by (1 + (I / current_A)^exponent)^(-1 / exponent).
struct Saturation {
  double current_A = 0.0;  ///< Current in the actuator's convention; infinite: no saturation.
  double exponent = 0.0;
};

/// A direction in an effect's parameters along which an experiment is planned. Values are in the
/// order of the parameters; of one that is `at_least` another, the excess over it.
struct Probe {
  std::string parameter;     ///< Name of the parameter in the plan.
  std::string at;            ///< Typical values at which it stands, in words; may be empty.
  std::vector<double> low;   ///< Values on the one side; empty: an actuator without the effect.
  std::vector<double> high;  ///< The values on the other side.
  double change = 1.0;       ///< Difference of the parameter between the two.
};

}  // namespace torquewright::actuator
