// SPDX-License-Identifier: Apache-2.0
#include "hopper/record/run_series.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::array kAxes{"x", "y", "z"};

/// An empty cell: before the first step the buses are not known.
constexpr double kNotYet = std::numeric_limits<double>::quiet_NaN();

/// Columns from one vector of every row.
class Columns {
 public:
  Columns(const Record& record, Series& series) : record_(record), series_(series) {}

  template <typename Value>
  void add(std::string header, const Value& value) {
    VectorXd values(static_cast<Index>(record_.rows.size()));
    for (std::size_t i = 0; i < record_.rows.size(); ++i) {
      values[static_cast<Index>(i)] = value(record_.rows[i]);
    }
    series_.push_back({std::move(header), std::move(values)});
  }

  void add_entry(std::string header, VectorXd RecordRow::*vector, Index entry) {
    add(std::move(header), [&](const RecordRow& row) { return (row.*vector)[entry]; });
  }

 private:
  const Record& record_;
  Series& series_;
};

void add_base(const dynamics::Tree& tree, Columns& columns) {
  if (tree.base == dynamics::BaseKind::kPlanar) {
    columns.add_entry("base_x_position_m", &RecordRow::position, 0);
    columns.add_entry("base_z_position_m", &RecordRow::position, 1);
    columns.add_entry("base_pitch_position_rad", &RecordRow::position, 2);
    columns.add_entry("base_x_velocity_m_s", &RecordRow::velocity, 0);
    columns.add_entry("base_z_velocity_m_s", &RecordRow::velocity, 1);
    columns.add_entry("base_pitch_velocity_rad_s", &RecordRow::velocity, 2);
  }
  if (tree.base != dynamics::BaseKind::kSpatial) return;
  for (Index i = 0; i < 3; ++i) {
    columns.add_entry(fmt::format("base_{}_position_m", kAxes[static_cast<std::size_t>(i)]),
                      &RecordRow::position, i);
  }
  constexpr std::array kQuaternion{"qw", "qx", "qy", "qz"};
  for (Index i = 0; i < 4; ++i) {
    columns.add_entry(fmt::format("base_{}_position", kQuaternion[static_cast<std::size_t>(i)]),
                      &RecordRow::position, 3 + i);
  }
  for (Index i = 0; i < 6; ++i) {
    const char* axis = kAxes[static_cast<std::size_t>(i % 3)];
    columns.add_entry(i < 3 ? fmt::format("base_{}_velocity_m_s", axis)
                            : fmt::format("base_angular_{}_velocity_rad_s", axis),
                      &RecordRow::velocity, i);
  }
}

void add_joints(const dynamics::Tree& tree, Columns& columns) {
  const auto joints = static_cast<Index>(tree.bodies.size()) - 1;
  for (Index i = 0; i < joints; ++i) {
    const dynamics::Joint& joint = tree.bodies[static_cast<std::size_t>(i) + 1].joint;
    const bool turns = joint.kind == dynamics::JointKind::kRevolute;
    columns.add_entry(fmt::format("{}_position_{}", joint.name, turns ? "rad" : "m"),
                      &RecordRow::position, tree.position_size() - joints + i);
    columns.add_entry(fmt::format("{}_velocity_{}", joint.name, turns ? "rad_s" : "m_s"),
                      &RecordRow::velocity, tree.velocity_size() - joints + i);
  }
}

void add_drives(const Robot& robot, const Record& record, Columns& columns) {
  Index drive = 0;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (std::size_t i = 0; i < drivetrain.actuator_names.size(); ++i) {
      const std::string& name = drivetrain.actuator_names[i];
      columns.add_entry(name + "_drive_speed_rad_s", &RecordRow::speed_rad_s, drive);
      columns.add_entry(name + "_drive_wanted_torque_Nm", &RecordRow::wanted_Nm, drive);
      columns.add_entry(name + "_drive_torque_Nm", &RecordRow::torque_Nm, drive);
      columns.add_entry(name + "_drive_cut_off_torque_Nm", &RecordRow::cut_off_Nm, drive);
      const bool has_winding = !drivetrain.actuators[i].envelope;
      if (has_winding && record.rows.back().bus_V.size() > drive) {
        columns.add(name + "_bus_voltage_V", [drive](const RecordRow& row) {
          return row.bus_V.size() > drive ? row.bus_V[drive] : kNotYet;
        });
      }
      ++drive;
    }
  }
}

}  // namespace

Series run_series(const Robot& robot, const Record& record) {
  Series series;
  if (record.rows.empty()) return series;
  Columns columns(record, series);
  columns.add("time_s", [](const RecordRow& row) { return row.time_s; });
  add_base(robot.tree, columns);
  add_joints(robot.tree, columns);
  add_drives(robot, record, columns);
  for (std::size_t i = 0; i < robot.contacts.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      columns.add(fmt::format("{}_mean_force_{}_N", robot.contacts[i].name, kAxes[axis]),
                  [&, at = static_cast<Index>(3 * i + axis)](const RecordRow& row) {
                    return row.impulses_N_s[at] / record.control_period_s;
                  });
    }
  }
  return series;
}

}  // namespace torquewright::hopper
