// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actuator/effects/effect.hpp"
#include "actuator/motor/convention.hpp"
#include "actuator/motor/envelope.hpp"
#include "actuator/unlimited.hpp"

namespace torquewright::actuator {

constexpr double kDefaultTemperature_K = 298.15;
/// Relative change of copper's resistance per kelvin, around room temperature.
constexpr double kCopperCoefficient_1_K = 0.0039;

/// The motor as its document states it: amperes, ohms and volts in the stated conventions.
/// Source of the conversions: convention.hpp.
struct Motor {
  double torque_constant_Nm_A = 0.0;
  CurrentConvention torque_constant_convention = CurrentConvention::kDc;
  std::optional<double> back_emf_constant_V_s_rad;  ///< Absent: follows from the torque constant.
  double resistance_ohm = 0.0;
  ResistanceConvention resistance_convention = ResistanceConvention::kDc;
  double inductance_d_H = 0.0;  ///< Of one phase.
  double inductance_q_H = 0.0;
  double pole_pairs = 1.0;
  double rotor_inertia_kg_m2 = 0.0;
  double winding_temperature_K = kDefaultTemperature_K;  ///< At which the above holds.
  double demagnetisation_current_A = kUnlimited;         ///< Largest negative d current.
  friend bool operator==(const Motor&, const Motor&) = default;
};

struct Drive {
  double bus_voltage_V = 0.0;
  double peak_current_A = 0.0;
  std::optional<double> continuous_current_A;
  double supply_current_A = kUnlimited;  ///< The most that it takes from the bus.
  Modulation modulation = Modulation::kSvpwm;
  bool field_weakening = false;
  bool regeneration = true;  ///< False: no power flows back to the bus.
  double regeneration_limit_W = kUnlimited;
  friend bool operator==(const Drive&, const Drive&) = default;
};

/// Open-circuit voltage of one cell at a state of charge (1 full).
struct ChargePoint {
  double state_of_charge;
  double voltage_V;
  friend bool operator==(const ChargePoint&, const ChargePoint&) = default;
};

struct Battery {
  double series_cells = 1.0;
  double parallel_cells = 1.0;
  std::vector<ChargePoint> cell_open_circuit;  ///< Ascending in charge; one: no curve was stated.
  double cell_resistance_ohm = 0.0;
  std::optional<double> cell_capacity_Ah;  ///< Of one full cell.
  double wiring_resistance_ohm = 0.0;      ///< Between pack and drive.
  double discharge_limit_A = kUnlimited;
  double charge_limit_A = kUnlimited;
  double maximum_voltage_V = kUnlimited;  ///< Of the pack while it is charged.
  friend bool operator==(const Battery&, const Battery&) = default;
};

/// Two nodes: winding and case. Resistances in K/W, capacities in J/K.
struct Thermal {
  double winding_to_case_K_W = 0.0;
  double case_to_ambient_K_W = 0.0;
  double winding_J_K = 0.0;
  double case_J_K = 0.0;
  double winding_limit_K = 0.0;
  double ambient_K = kDefaultTemperature_K;
  friend bool operator==(const Thermal&, const Thermal&) = default;
};

/// What stands between rotor and joint. `ratio` is rotor speed over joint speed, signed.
struct Transmission {
  double ratio = 1.0;
  double forward_efficiency = 1.0;   ///< Motor drives.
  double backward_efficiency = 1.0;  ///< Joint drives; 0: self-locking.
  double inertia_kg_m2 = 0.0;        ///< Of the gears, at the joint.
  double peak_torque_Nm = kUnlimited;
  std::string source;  ///< The document it was computed from; empty: stated inline.
  friend bool operator==(const Transmission&, const Transmission&) = default;
};

/// What limits the current at stall.
enum class StallLimit { kWinding, kDrive };

/// Numbers of the datasheet that follow from others, as printed: no region uses them.
struct Datasheet {
  bool joint_side = false;
  std::optional<double> voltage_V;  ///< At which the speeds hold; absent: the bus voltage.
  std::optional<double> no_load_speed_rad_s;
  std::optional<double> maximum_speed_rad_s;  ///< Of bearings, teeth or drive.
  std::optional<double> no_load_current_A;
  std::optional<double> stall_torque_Nm;
  std::optional<double> stall_current_A;
  std::optional<StallLimit> stall_limit;  ///< Of that current; absent: the winding, it seems.
  std::optional<double> peak_torque_Nm;
  std::optional<double> peak_torque_current_A;
  std::optional<double> peak_braking_torque_Nm;  ///< The joint driven back at the peak current.
  std::optional<double> rated_torque_Nm;
  std::optional<double> peak_power_W;
  std::optional<double> velocity_constant_rpm_V;
  std::optional<double> backlash_rad;  ///< The whole width, at the output.
  std::optional<double> reflected_inertia_kg_m2;
  std::optional<double> electrical_time_constant_s;
  std::optional<double> mechanical_time_constant_s;  ///< Of the rotor alone.
};

/// What a number is that its sheet prints behind > or <.
enum class Bound { kAtLeast, kAtMost };

/// What a document says of one of its numbers beside the number:
/// {"value": 2.36, "side": "joint", "ampere": "rms", "tolerance": 0.1}.
struct Statement {
  std::string pointer;                      ///< "/motor/torque_constant_Nm_A"
  double printed = 0.0;                     ///< The number as it stands there.
  std::optional<bool> at_joint;             ///< Else as the key, or the data sheet, has it.
  std::optional<CurrentConvention> ampere;  ///< Else the torque constant's.
  std::optional<double> tolerance;          ///< Share of the number, either way.
  std::vector<double> also;                 ///< What other sources state in its place.
  std::optional<Bound> bound = {};          ///< The true number lies on one side of it.
};

/// A document of kind `actuator`.
struct Actuator {
  std::string name;
  Motor motor;
  Drive drive;
  /// A curve in the place of motor and drive: the motor's current is then its torque, and it has no
  /// winding.
  std::optional<Envelope> envelope;
  std::optional<Battery> battery;
  std::optional<Thermal> thermal;
  Transmission transmission;
  std::vector<Effect> effects;
  std::optional<double> mass_kg;  ///< Of all of it.
  std::optional<Datasheet> datasheet;
  std::vector<std::string> assumed;  ///< JSON pointers of assumed values.
  /// What the document says of numbers beside their value. The values above are carried to the
  /// motor and to the torque constant's ampere already (carry_to_motor).
  std::vector<Statement> statements;
};

}  // namespace torquewright::actuator
