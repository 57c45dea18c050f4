// SPDX-License-Identifier: Apache-2.0
// The robot under its loops, simulated by MuJoCo.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/oracles/robot_bench/laws.hpp"
#include "tests/oracles/robot_bench/model_file.hpp"
#include "tests/oracles/robot_bench/robot.hpp"

namespace torquewright::oracles::robot_bench {

/// What hangs there in truth.
struct Scene {
  Robot robot;
  std::map<std::string, Laws> laws;  ///< By joint that moves.
  std::map<std::string, Controller> controllers;
  Cable cable;
  Gantry gantry;
  double roll_rad = 0, pitch_rad = 0;  ///< How the base hangs.
};

/// What a host sends: each joint's target, packet by packet; a drive holds it until the next.
struct Commands {
  double packet_s = 0.005, delay_s = 0;
  std::vector<std::vector<double>> targets_rad;  ///< By joint that moves, in order.

  double at(std::size_t joint, double time_s) const;
  /// Mean over a time that is shorter than a packet.
  double mean(std::size_t joint, double from_s, double to_s) const;
  double duration_s() const;
};

/// Samples of what is true, at the log's instants; by joint that moves, in order.
struct Record {
  std::vector<double> time_s;
  std::vector<std::vector<double>> position_rad, speed_rad_s, command_rad, torque_Nm;
};

/// Kinetic and potential energy; spring and twist are not among them.
struct Energy {
  double kinetic_J = 0, potential_J = 0;
};

std::string mjcf(const Scene& scene, double step_s);

class Plant {
 public:
  Plant(const Scene& scene, double step_s);

  void start_at(const std::vector<double>& position_rad);
  void step(const std::vector<double>& command_rad);

  std::size_t joints() const { return axes_.size(); }
  /// As the drive's encoder has it: of the rotor where a belt slips.
  double measured_rad(std::size_t joint) const;
  double measured_rad_s(std::size_t joint) const { return speed_rad_s(axes_[joint]); }
  double motor_torque_Nm(std::size_t joint) const { return axes_[joint].motor_Nm; }
  Energy energy();
  const mjModel& model() const { return *model_; }

 private:
  struct Axis {
    std::string name;
    Laws laws;
    Controller controller;
    int dof = 0, rotor = -1, body = 0;
    double motor_Nm = 0, gear_Nm = 0, slipped_rad = 0;
  };

  int measured_dof(const Axis& axis) const { return axis.laws.slips() ? axis.rotor : axis.dof; }
  double speed_rad_s(const Axis& axis) const;
  void drive(Axis& axis, double command_rad);
  void twist(Axis& axis);
  void set_friction(const Axis& axis);
  void pull_cable();
  void note_gear_torques();

  const Scene& scene_;
  Model model_;
  Data data_;
  std::vector<Axis> axes_;
  std::vector<double> inertial_;
};

/// Plays the commands from rest at the first of them; `row_s` apart. Steps are 0.25 ms, with a
/// spring between rotor and output 0.1 ms, over `finer`.
Record play(const Scene& scene, const Commands& commands, double row_s, int finer = 1);

}  // namespace torquewright::oracles::robot_bench
