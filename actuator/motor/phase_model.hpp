// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "actuator/motor/envelope.hpp"
#include "actuator/motor/supply.hpp"

namespace torquewright::actuator {

/// What sets a bound of the region. The names are the contract's.
enum class Limiter {
  kCurrent,
  kVoltage,
  kFieldWeakening,  ///< No current within the limit meets both torque and voltage.
  kRegeneration,    ///< The bus takes no more power back.
  kBatteryPower,
  kGear,
  kThermal,
  kDemagnetisation,
  kEnvelope,  ///< The curve by which the drive is known.
};
std::string_view name_of(Limiter limiter);

/// Phase current in the rotor's frame: amplitudes in amperes (docs/notation.md).
struct Current {
  double d_A = 0.0;
  double q_A = 0.0;
  double amplitude_A() const;
};

/// The electrical side at one set of conditions, everything as amplitudes of one phase and at the
/// rotor: a motor at its temperature, behind its drive, on its supply. Signs: positive q current
/// drives positive speed.
struct PhaseModel {
  double torque_constant_Nm_A = 0.0;  ///< Unsaturated, of q current alone.
  double back_emf_V_s_rad = 0.0;
  double resistance_ohm = 0.0;
  double inductance_d_H = 0.0;
  double inductance_q_H = 0.0;
  double pole_pairs = 1.0;
  double saturation_current_A = 0.0;  ///< 0: none. Else torque falls by (1 + (i/i_s)^p)^(-1/p).
  double saturation_exponent = 2.0;
  double dead_time_V = 0.0;  ///< Lost along the current.
  double current_limit_A = 0.0;
  Limiter current_limiter = Limiter::kCurrent;
  double demagnetisation_current_A = 0.0;  ///< Largest negative d current; may be infinite.
  bool field_weakening = false;
  Supply supply;
  double phase_volts_per_bus_volt = 0.0;
  /// All that limits a drive which is known by its curve alone, at the rotor. Null: the members
  /// above do.
  std::shared_ptr<const EnvelopeCurve> envelope;

  /// Torque of reluctance per product of currents, in Nm/A^2: 1.5 p (L_d - L_q).
  double reluctance_Nm_A2() const;
};

/// T = s(i_q) (K i_q + 1.5 p (L_d - L_q) i_d i_q), s the saturation.
/// docs/derivations/motor_region.md eq. (1).
double torque_Nm(const PhaseModel& model, const Current& current);

/// The q current that yields the torque with that d current: the inverse of the above. Infinite
/// where saturation admits no such torque.
double q_current_A(const PhaseModel& model, double torque_Nm, double d_A);

/// Heat of the windings' copper in W, 1.5 R |i|^2.
double copper_loss_W(const PhaseModel& model, const Current& current);

/// Power that the induced voltage takes up, per speed: 1.5 K_e i_q + 1.5 p (L_d - L_q) i_d i_q. It
/// is the torque where the constants belong together and nothing saturates.
double induced_Nm(const PhaseModel& model, const Current& current);

/// Power at the bus, volts times amperes at the motor's terminals and what the bridge's dead time
/// takes: copper, and what the induced voltage takes up. Eq. (4).
double bus_power_W(const PhaseModel& model, const Current& current, double speed_rad_s);

/// Amplitude of the phase voltage that the current needs at that speed. Eq. (2), (3).
double phase_voltage_V(const PhaseModel& model, const Current& current, double speed_rad_s);

/// What is left of the phase voltage, with the bus voltage that the power itself leaves (negative:
/// it does not suffice; minus infinity where the supply cannot deliver the power at all). Eq. (6).
double voltage_margin_V(const PhaseModel& model, const Current& current, double speed_rad_s);

}  // namespace torquewright::actuator
