// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/oracles/bench_log/plant.hpp"

namespace torquewright::oracles {

/// -1, 0 or 1.
inline double sign_of(double value) { return value > 0.0 ? 1.0 : (value < 0.0 ? -1.0 : 0.0); }

/// The state of a drive on its load, and one step of it. Positions and speeds of the motor are
/// referred to the output (divided by the ratio).
class Simulation {
 public:
  Simulation(const Machine& machine, const RunPlan& plan);

  /// The state at the knot, into the trace.
  void record(Trace& trace) const;
  /// From one knot to the next; the current runs straight to `next_current_A` (or the winding's
  /// voltage to `next_voltage_V`) meanwhile.
  void tick(std::size_t knot, int substeps);
  /// The current (voltage) at the next knot.
  void aim(std::size_t next_knot);
  EnergyAccount account() const;

 private:
  struct Drive {  ///< What acts on the motor's side, friction and gear apart.
    double torque_Nm, current_A;
  };
  bool is_imposed() const { return machine_.load.type == Load::Type::kDynamometer; }
  Drive drive_at(double share, double step_s);
  double rotor_ripple_Nm(double motor_rad, double motor_rad_s, double torque_Nm) const;
  double output_ripple_Nm(double rad) const;
  double load_Nm(double rad) const;
  Situation situation(double rad, double rad_s) const;
  void slip(double moved_rad, double direction);
  void imposed_rigid_step(std::size_t knot, double from, double to);
  void rigid_step(double step_s, const Drive& drive);
  int rigid_start(const Drive& drive) const;
  double rigid_acceleration(double rad, double rad_s, double direction, const Drive& drive,
                            double* friction, double* on_load) const;
  void two_mass_step(std::size_t knot, double from, double to, const Drive& drive);
  double spring_Nm(double twist_rad, double twist_rad_s) const;
  double motor_kick(double step_s, double rad, double spring, const Drive& drive);
  void heat(double step_s);
  double stored_J() const;

  const Machine& machine_;
  const RunPlan& plan_;
  ImposedMotion imposed_;
  double time_s_ = 0.0;
  double q_, w_, a_ = 0.0;   ///< Output.
  double qm_, wm_;           ///< Motor, at the output.
  double bristle_Nm_ = 0.0;  ///< Presliding.
  double lagged_Nm_ = 0.0;
  double current_A_ = 0.0, next_current_A_ = 0.0;
  double voltage_V_ = 0.0, next_voltage_V_ = 0.0;
  double torque_Nm_ = 0.0;  ///< On the load.
  double winding_K_, case_K_;
  double since_reversal_s_ = 1e9;
  double last_direction_ = 0.0;
  double start_stored_J_ = 0.0;
  double contact_Nm_rad_ = 0.0, contact_Nm_s_rad_ = 0.0;
  EnergyAccount account_;
};

}  // namespace torquewright::oracles
