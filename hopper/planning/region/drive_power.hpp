// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hopper/planning/region/held_bus.hpp"
#include "hopper/planning/region/smooth_step.hpp"

namespace torquewright::hopper {

/// Power that a drive takes from its bus, as actuator::demand_at has it: shaft, copper and what
/// else there is between volts times amperes and these, of the motor torque that the load's torque,
/// mean drag and the gear's losses need. docs/derivations/planned_regions.md eq. (8) to (10).
class DrivePower {
 public:
  /// Smooth where gear losses and drag turn round, within `step_rad_s` about rest.
  DrivePower(const HeldBus& bus, double cap_Nm, double end_rad_s, double step_rad_s);

  template <typename T>
  T W(const T& torque_Nm, const T& speed_rad_s) const {
    const T motor_Nm = this->motor_Nm(torque_Nm, speed_rad_s);
    T out = motor_Nm * speed_rad_s + copper_W_Nm2_ * (motor_Nm * motor_Nm);
    if (rest_) {
      const double M = dynamics::value_of(motor_Nm);
      const double w = dynamics::value_of(speed_rad_s);
      out += carried(rest_->at(M, w), motor_Nm, speed_rad_s);
    }
    return out;
  }

 private:
  /// Torque of the motor at the output, before the gear's losses.
  template <typename T>
  T motor_Nm(const T& torque_Nm, const T& speed_rad_s) const {
    T out = middle_ * torque_Nm;
    const double w = dynamics::value_of(speed_rad_s);
    if (half_ != 0.0) {
      const T size = carried(size_at(dynamics::value_of(torque_Nm)), torque_Nm);
      const Taylor step = step_.at(w);
      const Taylor turn{.value = 2.0 * step.value - 1.0, .x = 2.0 * step.x, .xx = 2.0 * step.xx};
      out += half_ * (size * carried(turn, speed_rad_s));
    }
    if (drag_slow_) out -= carried(drag_Nm(w), speed_rad_s);
    return out;
  }

  Taylor size_at(double torque_Nm) const;
  Taylor drag_Nm(double speed_rad_s) const;

  double copper_W_Nm2_ = 0.0;
  double middle_ = 1.0;     ///< Of what the mesh asks for driving and driven back, per torque,
  double half_ = 0.0;       ///< and half their difference.
  double corner_Nm_ = 0.0;  ///< Over which |torque| is rounded.
  SmoothStep step_;
  std::optional<SmoothCurve> drag_slow_;  ///< Mean of drag and cogging at negative speeds,
  std::optional<SmoothCurve> drag_fast_;  ///< and at others.
  /// Power that is neither the shaft's nor copper loss of the least current, in W.
  std::optional<SmoothSurface> rest_;
};

}  // namespace torquewright::hopper
