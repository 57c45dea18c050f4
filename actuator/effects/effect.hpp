// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "actuator/effects/effect_properties.hpp"
#include "actuator/effects/excitations.hpp"

namespace torquewright::actuator {

/// Where an effect acts, and so what its law returns.
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

/// The instant at which a law is asked. Output side unless said; torque is what acts on the load.
struct Instant {
  double speed_rad_s = 0.0;
  /// Sign of the motion, also at rest: -1, 0 or 1. Between them its mean, where an instant stands
  /// for a time in which the motion reverses.
  double direction = 0.0;
  double acceleration_rad_s2 = 0.0;
  double load_torque_Nm = 0.0;  ///< On the load; driving where its sign is that of the motion.
  double current_A = 0.0;       ///< In the actuator's convention.
  double bus_current_A = 0.0;
  double output_angle_rad = 0.0;
  double motor_angle_rad = 0.0;  ///< Mechanical.
  double winding_temperature_K = 298.15;
  double reference_temperature_K = 298.15;
  double twist_rad = 0.0;  ///< Motor angle over ratio, less output angle.
  double twist_rate_rad_s = 0.0;
  double input = 0.0;  ///< What a lag follows: the torque that was asked for.
  double state = 0.0;  ///< Of an effect that has one.
};

/// One parameter: its unit is the end of its name (dimensionless where there is none).
struct Parameter {
  std::string_view name;
  double lowest;  ///< Physically possible bounds.
  double highest;
  double neutral;  ///< At which the effect changes nothing; may be infinite.
  std::string_view meaning;
  bool is_scale = false;           ///< Positive, and sought by its logarithm.
  std::string_view at_least = {};  ///< Another parameter, which it is not below.
  double steepness = 1.0;          ///< It may be so many times what the ranges' own quotient is.
};

/// What a log or a motion covers: largest magnitudes (of nearly all samples), and widths.
struct Ranges {
  double torque_Nm = 1.0;  ///< At the output.
  double speed_rad_s = 1.0;
  double acceleration_rad_s2 = 1.0;
  double current_A = 1.0;
  double voltage_V = 1.0;
  double angle_rad = 1.0;        ///< Of the output, from end to end.
  double motor_angle_rad = 1.0;  ///< Of the rotor.
  double warmth_K = 0.0;         ///< Away from the reference.
};

/// The most that a motion asks of a drive, in size. At the output.
struct MotionExtremes {
  double torque_Nm = 0.0;
  double torque_rate_Nm_s = 0.0;     ///< Of the torque from one sample to the next.
  double motor_inertia_kg_m2 = 0.0;  ///< Of rotor and gears.
};

/// A sum of A sin(order angle + phase). `amplitude` is in Nm, or dimensionless where the ripple is
/// proportional to the load.
struct Harmonic {
  double order = 1.0;
  double amplitude = 0.0;
  double phase_rad = 0.0;
  friend bool operator==(const Harmonic&, const Harmonic&) = default;
};

struct Effect;

/// A kind of effect: its law, written once. One file each in this folder, one line in library.cpp.
/// The laws and names are the contract (docs/effects.md).
struct EffectKind {
  std::string_view name;
  Acts acts;
  std::string_view sentence;              ///< The physics, for a person.
  std::span<const Parameter> parameters;  ///< The scalar ones.
  bool has_harmonics = false;             ///< Parameters are a list of harmonics besides.
  double (*law)(const Effect&, const Instant&);
  /// d state / dt; null: no state.
  double (*state_rate)(const Effect&, const Instant&) = nullptr;
  std::string_view state;  ///< What the state is, with its unit.
  /// Whether its harmonics may be ratios of the load.
  bool may_be_proportional = false;
  /// Its state follows the torque of the motor (Instant::input), not the motion.
  bool follows_torque = false;

  /// Where it stands in an elastic train.
  TrainPart in_train = TrainPart::kNone;
  /// By how far the motor leads its output, in rad at the output, at rest under a torque on the
  /// load, in Nm. Null: by nothing.
  double (*twist_rad)(const Effect&, double torque_Nm) = nullptr;
  /// The greatest slope of its torque by an angle, in Nm/rad: of a part of a train by the twist, of
  /// all others by the output's angle, as a spring to the frame. Null: none; infinite: rigid.
  double (*stiffness_Nm_rad)(const Effect&) = nullptr;
  /// What it holds where the output stands.
  AtRest at_rest = AtRest::kNothing;
  /// How the torque constant falls with the current. Null: it does not.
  Saturation (*saturation)(const Effect&) = nullptr;

  Needs needs = {};                               ///< What a log has to hold.
  Excitation excited_by = effects::kMixedMotion;  ///< What shows it apart from others.
  StandsFor stands_for = StandsFor::kItself;      ///< What it cannot be told from on some benches.
  /// What it means for the region where the log cannot tell it from what it stands for; a sentence.
  std::string_view consequence = {};
  /// Effects that are special cases of it: it takes their place.
  std::span<const std::string_view> contains = {};
  /// Effects that it turns into towards an end of its parameters: it may stand beside them, but a
  /// log that shows no more than they do has their name.
  std::span<const std::string_view> tends_to = {};
  /// Values from which a fit may start; null: the neutral ones.
  std::vector<std::vector<double>> (*starts)(const Ranges&) = nullptr;

  Presence presence = Presence::kSome;  ///< Whether an experiment is planned for it unasked.
  /// Directions along which an experiment is planned, of a law that is not linear in its
  /// parameters; null: each parameter by itself. `start`: from where a fit starts; `step`: a small
  /// change of each parameter.
  std::vector<Probe> (*probes)(const Ranges&, std::span<const double> start,
                               std::span<const double> step) = nullptr;
  /// Of one with harmonics: the wave that an experiment is planned for, so many times in a turn of
  /// the output, or of a pole pair where it acts before the mesh.
  double typical_order = 0.0;

  /// An estimate of the torque at the output, in Nm, by which a motion of these extremes is
  /// misjudged at most where the effect is left out; null: its law says, sample by sample.
  double (*misjudged_Nm)(const Effect&, const MotionExtremes&) = nullptr;
};

/// An effect as a document states it.
struct Effect {
  const EffectKind* kind = nullptr;
  std::vector<double> values;  ///< In the order of kind->parameters.
  std::vector<Harmonic> harmonics;
  bool proportional = false;  ///< Amplitudes are ratios of the load.
  std::string provenance;     ///< As written: "assumed", "measured", "identified", ...
  friend bool operator==(const Effect&, const Effect&) = default;
};

}  // namespace torquewright::actuator
