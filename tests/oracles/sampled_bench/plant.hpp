// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

namespace torquewright::oracles::sampled {

inline constexpr double kTwoPi = 2.0 * std::numbers::pi;
inline constexpr double kGravity_m_s2 = 9.80665;
inline constexpr double kReference_K = 298.15;
inline constexpr double kCopper_1_K = 0.0039;

enum class LoadKind { kImposedSpeed, kBrake, kFree, kPendulum, kLinearAxis };
enum class DriveKind { kCurrent, kCommandedTorque, kDuty, kWindingVoltage };

/// What moves: at the output. A brake's torque is a signal of the run; an imposed speed has no
/// inertia.
struct Load {
  LoadKind kind = LoadKind::kImposedSpeed;
  double inertia_kg_m2 = 0.0;  ///< A linear axis: its mass. A pendulum: about its centre of mass.
  double mass_kg = 0.0;        ///< Pendulum.
  double length_m = 0.0;       ///< Pendulum.

  double about_axis_kg_m2() const { return inertia_kg_m2 + mass_kg * length_m * length_m; }
  double gravity_Nm() const { return mass_kg * kGravity_m_s2 * length_m; }
  bool is_dynamometer() const {
    return kind == LoadKind::kImposedSpeed || kind == LoadKind::kBrake;
  }
};

/// Two nodes: the winding heats the case, the case the air.
struct Heating {
  double winding_to_case_K_W = 1.0;
  double case_to_ambient_K_W = 1.0;
  double winding_J_K = 50.0;
  double case_J_K = 500.0;
};

/// An actuator of one equivalent winding (convention `dc`) as it is stated.
struct Plant {
  double ratio = 1.0;  ///< Rotor speed over output speed.
  double torque_constant_Nm_A = 0.1;
  double resistance_ohm = 0.1;
  double inductance_H = 1e-5;  ///< Of the equivalent winding.
  double rotor_inertia_kg_m2 = 1e-4;
  double bus_V = 48.0;
  double peak_current_A = 20.0;
  double forward_efficiency = 1.0;
  double backward_efficiency = 1.0;
  Heating heating;
  Load load;
  DriveKind drive = DriveKind::kCurrent;
  double used_torque_Nm = 1.0;  ///< What the excitation asks for, about.
  double used_speed_rad_s = 1.0;
  double used_angle_rad = 1.0;

  double Nm_per_A() const { return ratio * torque_constant_Nm_A; }
  double armature_kg_m2() const { return ratio * ratio * rotor_inertia_kg_m2; }
  double moved_kg_m2() const { return armature_kg_m2() + load.about_axis_kg_m2(); }
  bool is_voltage_driven() const {
    return drive == DriveKind::kDuty || drive == DriveKind::kWindingVoltage;
  }
};

}  // namespace torquewright::oracles::sampled
