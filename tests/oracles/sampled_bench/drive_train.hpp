// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/oracles/sampled_bench/laws.hpp"

namespace torquewright::oracles::sampled {

/// What is held during one step.
struct StepInput {
  double command = 0.0;        ///< Current (A) of a current loop, else the duty or winding voltage.
  double brake_Nm = 0.0;       ///< Torque of the test bench's brake on the load.
  double imposed_rad_s = 0.0;  ///< Load speed at the step's end, where it is imposed.
};

/// Winding, motor and load, advanced in small steps. Speeds follow from a balance of impulses in
/// which dry friction and the mesh's losses are set-valued at rest (time stepping after Moreau):
/// stick and slip are decided exactly, without a regularised sign. Springs, damping and the winding
/// are implicit.
class DriveTrain {
 public:
  DriveTrain(const Plant& plant, const Laws& laws, double step_s, double current_loop_s)
      : plant_(plant), laws_(laws), step_s_(step_s), current_loop_s_(current_loop_s) {}

  /// At rest, or at the imposed speed, at the run's start.
  void start(double time_s, double angle_rad, double speed_rad_s, double winding_K);
  void advance(const StepInput& input);
  const Instant& now() const { return now_; }

 private:
  /// Torque that the mesh must deliver at the motor's new speed w: constant + slope w.
  struct Port {
    double constant = 0.0, slope = 0.0;
  };
  void advance_winding(const StepInput& input);
  void advance_heat();
  Port rigid_port(const StepInput& input) const;
  Port spring_port(const StepInput& input, bool in_contact) const;
  double bristle_after(double speed_rad_s, double level_Nm) const;
  double mesh_torque(double speed_rad_s, double sign) const;
  double solve_speed(const Port& port) const;
  double imposed_mesh_torque(double speed_rad_s) const;
  void advance_rigid(const StepInput& input);
  void advance_two_mass(const StepInput& input);
  void finish(double motor_speed, double load_speed, double mesh_Nm, const StepInput& input);
  double load_side_Nm(const StepInput& input) const;
  double load_inertia() const;
  double contact_rad() const;

  Plant plant_;
  Laws laws_;
  double step_s_, current_loop_s_;
  Instant now_;
  double before_mesh_Nm_ = 0.0;  ///< Magnets and cogging during the step.
  double ripple_share_ = 0.0;
};

}  // namespace torquewright::oracles::sampled
