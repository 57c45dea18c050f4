// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "actuator/effects/effect_properties.hpp"
#include "actuator/effects/excitations.hpp"

namespace torquewright::actuator {

/// The place where an effect acts, which decides what its law returns.
enum class Acts {
  kDrag,              ///< Friction that does not depend on load: torque on the output, in Nm.
  kDragFactor,        ///< Factor on all drag.
  kLoadFriction,      ///< Friction in proportion to the load: torque on the output, in Nm.
  kTorqueFactor,      ///< Factor on the torque constant, at the current that flows.
  kFluxFactor,        ///< Factor on the magnet's flux: torque constant and back-EMF alike.
  kResistanceFactor,  ///< Factor on the winding's resistance.
  kWindingVoltage,    ///< Voltage lost between drive and winding, in the winding's convention.
  kBusVoltage,        ///< Change of the bus voltage, in V.
  kMotorSideTorque,   ///< Periodic torque before the gear's losses, referred to the output, in Nm.
  kOutputTorque,      ///< Torque at the output by its angle, in Nm; a region has that of waves.
  kInertialTorque,    ///< Torque on the output that follows acceleration, in Nm.
  kDynamics,          ///< Has a state; no static region can hold it.
};

/// The instant at which a law is evaluated. Quantities are on the output side unless said
/// otherwise; torque is that on the load.
struct Instant {
  double speed_rad_s = 0.0;
  /// Sign of the motion, also at rest: -1, 0 or 1. Values between are means, where an instant
  /// stands for a time in which the motion reverses.
  double direction = 0.0;
  double acceleration_rad_s2 = 0.0;
  /// Torque on the load; it drives where its sign is that of the motion.
  double load_torque_Nm = 0.0;
  double current_A = 0.0;  ///< In the actuator's convention.
  double bus_current_A = 0.0;
  double output_angle_rad = 0.0;
  double motor_angle_rad = 0.0;  ///< Mechanical angle of the motor.
  double winding_temperature_K = 298.15;
  double reference_temperature_K = 298.15;
  double twist_rad = 0.0;  ///< Motor angle over ratio, less output angle.
  double twist_rate_rad_s = 0.0;
  double input = 0.0;  ///< Torque that was asked for, which a lag follows.
  double state = 0.0;  ///< State of an effect that has one.
};

/// A parameter of an effect; its unit is the end of its name (none: dimensionless).
struct Parameter {
  std::string_view name;
  double lowest;  ///< Bounds that are physically possible.
  double highest;
  double neutral;  ///< Value at which the effect changes nothing; may be infinite.
  std::string_view meaning;
  bool is_scale = false;           ///< It is positive, and searched by its logarithm.
  std::string_view at_least = {};  ///< Name of another parameter that it is not below.
  double steepness = 1.0;          ///< Factor by which it may exceed the quotient of the ranges.
};

/// Ranges that a log or a motion covers: largest magnitudes (of nearly all samples), and widths.
struct Ranges {
  double torque_Nm = 1.0;  ///< Torque at the output.
  double speed_rad_s = 1.0;
  double acceleration_rad_s2 = 1.0;
  double current_A = 1.0;
  double voltage_V = 1.0;
  double angle_rad = 1.0;        ///< Width of the output's angle.
  double motor_angle_rad = 1.0;  ///< Width of the rotor's angle.
  double warmth_K = 0.0;         ///< Greatest distance from the reference temperature.
};

/// Greatest demands of a motion on a drive, in size, at the output.
struct MotionExtremes {
  double torque_Nm = 0.0;
  double torque_rate_Nm_s = 0.0;     ///< Rate of the torque from one sample to the next.
  double motor_inertia_kg_m2 = 0.0;  ///< Inertia of rotor and gears.
};

/// One term of a sum of A sin(order angle + phase). `amplitude` is in Nm, or dimensionless where
/// the ripple is proportional to the load.
struct Harmonic {
  double order = 1.0;
  double amplitude = 0.0;
  double phase_rad = 0.0;
  friend bool operator==(const Harmonic&, const Harmonic&) = default;
};

struct Effect;

/// A kind of effect with its law, written once. Each is one file in this folder and one line in
/// every_effect.hpp; laws and names are documented in docs/effects.md.
struct EffectKind {
  std::string_view name;
  Acts acts;
  std::string_view sentence;              ///< The physics in a sentence for a user.
  std::span<const Parameter> parameters;  ///< The scalar parameters.
  bool has_harmonics = false;             ///< It has a list of harmonics besides.
  double (*law)(const Effect&, const Instant&);
  /// Rate of the state, d state / dt; null: it has no state.
  double (*state_rate)(const Effect&, const Instant&) = nullptr;
  std::string_view state;  ///< Name of the state, with its unit.
  /// Whether its harmonics may be ratios of the load.
  bool may_be_proportional = false;
  /// Its state follows the torque of the motor (Instant::input), not the motion.
  bool follows_torque = false;

  /// Place of the effect in an elastic train.
  TrainPart in_train = TrainPart::kNone;
  /// Angle by which the motor leads its output, in rad at the output, at rest under a torque on the
  /// load, in Nm. Null: none.
  double (*twist_rad)(const Effect&, double torque_Nm) = nullptr;
  /// Greatest slope of its torque by an angle, in Nm/rad: for a part of a train by the twist, for
  /// others by the output's angle, as of a spring to the frame. Null: none; infinite: rigid.
  double (*stiffness_Nm_rad)(const Effect&) = nullptr;
  /// Torque that it holds while the output rests.
  AtRest at_rest = AtRest::kNothing;
  /// Decrease of the torque constant with the current. Null: none.
  Saturation (*saturation)(const Effect&) = nullptr;

  Needs needs = {};  ///< Channels that a log has to hold.
  /// Motion that shows it apart from other effects.
  Excitation excited_by = effects::kMixedMotion;
  StandsFor stands_for = StandsFor::kItself;  ///< What it cannot be told from on some benches.
  /// A sentence on what it means for the region where the log cannot tell it from what it stands
  /// for.
  std::string_view consequence = {};
  /// Effects that are special cases of it, whose place it takes.
  std::span<const std::string_view> contains = {};
  /// Effects that it turns into towards an end of its parameters: it may stand beside them, but a
  /// log that shows no more than they do names them.
  std::span<const std::string_view> tends_to = {};
  /// Values from which a fit may start; null: the neutral ones.
  std::vector<std::vector<double>> (*starts)(const Ranges&) = nullptr;

  /// Whether an experiment is planned for it without being asked.
  Presence presence = Presence::kSome;
  /// Directions along which an experiment is planned, for a law that is not linear in its
  /// parameters; null: each parameter by itself. `start` is where a fit starts, `step` a small
  /// change of each parameter.
  std::vector<Probe> (*probes)(const Ranges&, std::span<const double> start,
                               std::span<const double> step) = nullptr;
  /// For an effect with harmonics: the order of the wave that an experiment is planned for, per
  /// turn of the output, or of a pole pair where it acts before the mesh.
  double typical_order = 0.0;

  /// Estimates the greatest torque at the output, in Nm, by which a motion of these extremes is
  /// misjudged where the effect is left out; null: its law says so sample by sample.
  double (*misjudged_Nm)(const Effect&, const MotionExtremes&) = nullptr;
};

/// An effect as a document states it.
struct Effect {
  const EffectKind* kind = nullptr;
  std::vector<double> values;  ///< Values in the order of kind->parameters.
  std::vector<Harmonic> harmonics;
  bool proportional = false;  ///< Amplitudes are ratios of the load.
  /// Source of the values, as written: "assumed", "measured", "identified", ...
  std::string provenance;
  friend bool operator==(const Effect&, const Effect&) = default;
};

}  // namespace torquewright::actuator
