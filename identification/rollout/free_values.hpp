// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "identification/rollout/robot_model.hpp"

namespace torquewright::identification {

/// A number of a robot's model that its motion may correct.
struct FreeValue {
  enum class Of {
    kRotor,   ///< Inertia of the rotor, in its drive's document.
    kEffect,  ///< A parameter of an effect of the drive.
    kWave,    ///< Of an effect's wave what goes with the cosine (even) or the sine (odd).
    kOffset,  ///< Of the encoder.
    kRoll,    ///< How the base hung, for all joints.
    kPitch,
    kMass,       ///< Of the body that the joint carries; its centre stays.
    kCenter,     ///< Of that body's centre of mass, along an axis of the body.
    kStiffness,  ///< Of the joint's controller.
    kDamping,
    kDelay,  ///< Of the command, at all joints where it is to be found.
  };
  Of of = Of::kRotor;
  std::size_t joint = 0;  ///< Of the rig; meaningless for the base.
  /// Other joints of the same hardware, whose number is the same.
  std::vector<std::size_t> sisters = {};
  std::string effect;         ///< Name of the effect; empty for others.
  std::size_t parameter = 0;  ///< Of the effect, its wave's part, or the axis of a centre.
  std::string name;           ///< Of the number, with its unit: "coulomb_Nm".
  double lowest = 0.0, highest = std::numeric_limits<double>::infinity();
  double size = 1.0;  ///< A change of it that shows.
  /// How far it may be from what is stated before the log is asked: what a calibration or a
  /// weighing leaves; infinite where nothing is known.
  double deviation = std::numeric_limits<double>::infinity();

  bool is_of(std::size_t one) const;  ///< Whether it is a number of this joint.
  bool is_of_all() const { return of == Of::kRoll || of == Of::kPitch || of == Of::kDelay; }
};

double value_in(const RobotModel& model, const FreeValue& which);
void set_value(RobotModel& model, const FreeValue& which, double value);

/// Makes the numbers of the joints' drives and controllers one number for each group of alike
/// joints that have it.
void tie(const std::vector<std::vector<std::size_t>>& alike, std::vector<FreeValue>& values);

/// Gives each drive that has no such law viscous and dry friction of nothing, so that a fit may
/// find them: what every joint has.
void add_plain_friction(RobotModel& model);

/// Gives a drive friction that varies with the output's angle as one wave of a turn does, of
/// nothing: over less than a turn it stands for any slow rise and fall.
void add_wave_of_friction(actuator::Actuator& drive);

/// Takes all such waves from a drive.
void erase_waves_of_friction(actuator::Actuator& drive);

/// Whether a drive has one.
bool has_wave_of_friction(const actuator::Actuator& drive);

/// Rotor, friction and encoder of each joint. Effects with a state, other waves, and parts of an
/// elastic train are left as they are.
std::vector<FreeValue> free_values(const RobotModel& model);

/// How the base hung: two angles.
std::vector<FreeValue> base_values();

/// What is to be found of the joints' controllers: gains, and one delay.
std::vector<FreeValue> controller_values(const RobotModel& model);

/// Mass and centre of mass of the body that each joint carries.
std::vector<FreeValue> body_values(const RobotModel& model);

}  // namespace torquewright::identification
