// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "actuator/conditions/held_region.hpp"
#include "actuator/heat/heat_model.hpp"
#include "actuator/mor/clip_table.hpp"
#include "hopper/replay/powered_drive_options.hpp"
#include "simulation/in_engine/joint_in_engine.hpp"

namespace torquewright::hopper {

/// Properties of a drive that do not change while it works.
struct FixedDrive {
  actuator::Actuator actuator;
  std::string file;           ///< Its document, for what is said of it.
  double turned_kg_m2 = 0.0;  ///< Inertia of rotor and gears, at the output.
  /// Whether the engine turns them with the output; else an elastic train has them to itself.
  bool turns_with_output = true;
  std::shared_ptr<const actuator::HeldRegion> region;
};

/// In what a drive differs from its document, unknown to whoever controls it.
struct UnknownOfDrive {
  double friction_Nm = 0.0;  ///< At the output, Coulomb's.
  double strength = 1.0;     ///< Of the motor: torque over what its current should make.
};

/// One drive during one step: a torque is wanted of it, a voltage holds it to a bound, it takes a
/// current and a power, and it warms (docs/derivations/replay_drives.md eqs. (1), (4)-(6)).
class WorkingDrive {
 public:
  /// Requires that there are no objections to the conditions. `fixed` must outlive it, and all
  /// copies of it.
  WorkingDrive(const FixedDrive& fixed, const PoweredDriveOptions& options,
               const UnknownOfDrive& unknown);

  void start();

  /// Begins a step with the wanted torque, in which the output turns at that speed.
  void want(double wanted_Nm, double output_speed_rad_s);
  /// Computes what the drive does with the bus at that voltage. Without voltage it is off.
  void hold(double bus_V);
  /// The motor makes that share of the torque that hold() left it, at the same speed.
  void make_only(double share, double bus_V);
  /// Switches the current off; what is left at the output is the drag that its document knows.
  void switch_off();
  /// Heats the winding with the current that flows.
  void end(double step_s);

  double power_W() const { return power_W_; }
  double current_A() const { return current_A_; }
  double cut_off_Nm() const { return wanted_Nm_ - made_Nm_; }
  /// Returns the torque that acts at the output, with all effects by simulation/joint, and further
  /// friction, which is smoothed about rest so widely that no step of this length reverses the
  /// motion. Once in a step, before end(). `output_position_rad` is where the step begins.
  double acting_Nm(double output_position_rad, double step_s);
  /// Torques between which it is held at that voltage, temperature and speed of its output.
  actuator::Interval range(double bus_V, double winding_K, double speed_rad_s) const;
  double winding_K() const { return nodes_.winding_K; }
  bool has_heat() const { return heat_.has_value(); }
  /// False of a drive that is known by its curve alone.
  bool has_winding() const { return !fixed_->actuator.envelope; }
  bool is_in_box() const { return box_.has_value(); }

 private:
  void load(double torque_Nm, double bus_V);
  bool is_same_current(double bus_V) const;
  double behind_line_V(double bus_V) const;
  double coasting_Nm() const;
  double given_Nm() const;
  double direction(double torque_Nm) const;
  double motor_Nm(double torque_Nm) const;

  const FixedDrive* fixed_;
  std::optional<actuator::ClipTable> box_;
  std::optional<actuator::HeatModel> heat_;
  std::optional<simulation::JointInEngine>
      joint_;  ///< Present where an effect acts that no drive compensates.
  actuator::NodeTemperatures start_;
  actuator::NodeTemperatures nodes_;
  UnknownOfDrive unknown_;
  double rest_width_rad_s_ = 0.0;
  // Of the step.
  actuator::PhaseModel model_;
  double wanted_Nm_ = 0.0;
  double speed_rad_s_ = 0.0;  ///< Speed of the motor, at the output.
  double output_speed_rad_s_ = 0.0;
  double held_Nm_ = 0.0;  ///< Torque after the bound by the voltage.
  double made_Nm_ = 0.0;  ///< and by what the battery gives.
  double power_W_ = 0.0;
  double current_A_ = 0.0;
  double phase_current_A_ = 0.0;
  /// Voltage that the current needs, where the field may be weakened.
  double needed_phase_V_ = 0.0;
  bool is_loaded_ = false;  ///< Current and power are those of made_Nm_.
};

}  // namespace torquewright::hopper
