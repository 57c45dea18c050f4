// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/preparation.hpp"

namespace torquewright::identification {

/// The torque balance of a bench at one instant, in Nm at the output, and how its residual follows
/// what is added to it. docs/derivations/identification.md eq. (2) to (6).
class Balance {
 public:
  explicit Balance(const Bench& bench);

  /// Where a sensor is the target: what the nominal actuator delivers. Else: the motor torque that
  /// the load needs. Never uses the measured target.
  double predicted_Nm(const Signals& signals, std::size_t i) const;

  /// The target of that prediction: the sensor's torque, or the motor's (of its stated constants).
  double measured_Nm(const Signals& signals, std::size_t i) const;

  /// Sensor: measured less predicted; else predicted less measured. So torque that is missing on
  /// the output has its own sign on every rig.
  double residual_Nm(const Signals& signals, std::size_t i) const;

  /// What one Nm before the mesh does to the residual.
  double gain(const Signals& signals, std::size_t i) const;

  /// What the torque constant multiplies, as far as the residual goes: N Kt i, or what is needed.
  double driven_Nm(const Signals& signals, std::size_t i) const;

  /// How the residual follows the torque constant, per its own size. Where a voltage drives, the
  /// back-EMF follows it too, unless the document states that one on its own.
  double of_torque_constant_Nm(const Signals& signals, std::size_t i) const;

  bool is_sensor() const { return is_sensor_; }
  const Bench& bench() const { return bench_; }

  /// Residual in the unit of the measured quantity per Nm, and that quantity.
  double unit_per_Nm() const;
  Quantity quantity() const;

 private:
  double needed_Nm(const Signals& signals, std::size_t i) const;

  Bench bench_;
  bool is_sensor_;
  double torque_per_ampere_Nm_A_;
  double reflected_inertia_kg_m2_;
};

}  // namespace torquewright::identification
