// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/drawn_numbers.hpp"

#include "hopper/trials/named_things.hpp"

namespace torquewright::hopper {
namespace {

class DrawnList {
 public:
  void add(const char* quantity, const std::optional<double>& value) {
    if (value) list_.push_back({quantity, "", *value});
  }

  void add(const char* quantity, const std::vector<NamedRange>& ranges, const NamedThings& things,
           const Eigen::VectorXd& values) {
    const std::vector<bool> is_drawn = drawn_of(ranges, things);
    for (std::size_t i = 0; i < is_drawn.size(); ++i) {
      if (!is_drawn[i]) continue;
      list_.push_back({quantity, things.names[i], values[static_cast<Eigen::Index>(i)]});
    }
  }

  void add_shifts(const std::vector<ShiftRange>& shifts, const NamedThings& bodies,
                  const Eigen::Matrix3Xd& values) {
    std::array<std::vector<bool>, 3> is_drawn;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<NamedRange> along;
      for (const ShiftRange& shift : shifts) {
        if (shift.along[axis]) along.push_back(shift.of_bodies);
      }
      is_drawn[axis] = drawn_of(along, bodies);
    }
    for (std::size_t body = 0; body < bodies.names.size(); ++body) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!is_drawn[axis][body]) continue;
        list_.push_back({"center_of_mass_shift_m",
                         bodies.names[body] + " " + std::string(1, "xyz"[axis]),
                         values(static_cast<Eigen::Index>(axis), static_cast<Eigen::Index>(body))});
      }
    }
  }

  std::vector<DrawnNumber> take() { return std::move(list_); }

 private:
  static std::vector<bool> drawn_of(const std::vector<NamedRange>& ranges,
                                    const NamedThings& things) {
    std::vector<bool> is_drawn(things.names.size());
    std::vector<io::Fault> faults;  // require_fits told them
    for (const NamedRange& range : ranges) {
      for (const std::size_t index : meant_by(range, things, "", faults)) is_drawn[index] = true;
    }
    return is_drawn;
  }

  std::vector<DrawnNumber> list_;
};

std::optional<double> if_drawn(bool is_drawn, double value) {
  return is_drawn ? std::optional(value) : std::nullopt;
}

}  // namespace

std::vector<DrawnNumber> drawn_numbers(const Trial& trial, const Randomisation& from,
                                       const Robot& robot) {
  const NamedThings bodies = drawing_bodies(robot);
  const NamedThings drives = drawing_drives(robot);
  const NamedThings joints = drawing_joints(robot);
  DrawnList list;
  const std::vector<NamedRange> masses =
      from.total_mass_factor ? std::vector{NamedRange{}} : from.body_mass_factor;
  list.add("mass_factor", masses, bodies, trial.mass_factor);
  list.add("body_inertia_factor", from.body_inertia_factor, bodies, trial.inertia_factor);
  list.add_shifts(from.center_of_mass_shift_m, bodies, trial.center_of_mass_shift_m);
  list.add("controller_gain_factor", from.controller_gain_factor, drives,
           trial.controller_gain_factor);
  list.add("motor_strength_factor", from.motor_strength_factor, drives,
           trial.motor_strength_factor);
  list.add("further_friction_Nm", from.further_friction_Nm, drives, trial.further_friction_Nm);
  list.add("friction_coefficient", trial.friction_coefficient);
  list.add("restitution", trial.restitution);
  list.add("ground_height_m", if_drawn(from.ground_height_m.has_value(), trial.ground_height_m));
  list.add("latency_s", if_drawn(from.latency_s.has_value(), trial.latency_s));
  list.add("state_of_charge", trial.state_of_charge);
  list.add("bus_voltage_factor",
           if_drawn(from.bus_voltage_factor.has_value(), trial.bus_voltage_factor));
  list.add("winding_temperature_K", trial.winding_temperature_K);
  list.add("initial_joint_position_rad", from.initial_joint_position_rad, joints,
           trial.initial_joint_position_rad);
  list.add("initial_joint_velocity_rad_s", from.initial_joint_velocity_rad_s, joints,
           trial.initial_joint_velocity_rad_s);
  return list.take();
}

}  // namespace torquewright::hopper
