// SPDX-License-Identifier: Apache-2.0
#include "hopper/check/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "actuator/drive_check/demand.hpp"
#include "actuator/drive_check/interpretation_check.hpp"
#include "actuator/region/torque_at.hpp"
#include "io/text/shown_number.hpp"
#include "io/text/unit_scales.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::array kAxes{"x", "y", "z"};
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

const char* effort_of(const dynamics::Joint& joint) {
  return joint.kind == dynamics::JointKind::kRevolute ? "torque_Nm" : "force_N";
}

class SeriesPass {
 public:
  SeriesPass(const Robot& robot, const Motion& motion, const CheckOptions& options,
             const HopperReport& report)
      : robot_(robot), motion_(motion), options_(options), report_(report) {}

  Series run(SeriesDetail detail) {
    add("time_s", Eigen::Map<const VectorXd>(motion_.times_s.data(), motion_.samples()));
    if (report_.demand.has_dynamics) add_joints();
    Index drive = 0;
    for (const Drivetrain& drivetrain : robot_.drivetrains) {
      for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i, ++drive) {
        add_torques(drivetrain.actuator_names[i], drive);
        if (detail == SeriesDetail::kDrives) {
          add_electrics(drivetrain.actuator_names[i], drivetrain.actuators[i], drive);
        }
      }
    }
    if (report_.demand.has_dynamics) add_body();
    return std::move(series_);
  }

 private:
  const Demand& demand() const { return report_.demand; }

  void add(std::string header, const Eigen::Ref<const VectorXd>& values) {
    series_.push_back({std::move(header), values});
  }

  void add_row(std::string header, const Eigen::MatrixXd& table, Index row) {
    add(std::move(header), table.row(row).transpose());
  }

  void add_axes(const std::string& name, const char* unit, const Eigen::MatrixXd& table,
                Index first = 0) {
    for (Index i = 0; i < 3; ++i) {
      add_row(fmt::format("{}_{}_{}", name, kAxes[static_cast<std::size_t>(i)], unit), table,
              first + i);
    }
  }

  void add_joints() {
    for (std::size_t body = 1; body < robot_.tree.bodies.size(); ++body) {
      const dynamics::Joint& joint = robot_.tree.bodies[body].joint;
      add_row(fmt::format("{}_joint_{}", joint.name, effort_of(joint)), demand().joint_effort,
              static_cast<Index>(body) - 1);
    }
  }

  void add_torques(const std::string& name, Index drive) {
    const auto& instants = demand().drives[static_cast<std::size_t>(drive)];
    VectorXd speeds(motion_.samples());
    std::transform(instants.begin(), instants.end(), speeds.begin(),
                   [](const DriveInstant& at) { return at.speed_rad_s; });
    add(name + "_drive_speed_rad_s", speeds);
    add_row(name + "_drive_torque_Nm", report_.torques_Nm, drive);
    add_row(name + "_gear_torque_Nm", report_.gears.joint_Nm, drive);
    add_row(name + "_gear_motor_torque_Nm", report_.gears.motor_Nm, drive);
    add_row(name + "_rotor_impulse_Nm_s", report_.gears.impulse_Nm_s, drive);
    if (demand().has_dynamics) add_row(name + "_contact_torque_Nm", demand().contact_Nm, drive);
  }

  /// Of each instant on the bus as it then stands.
  void add_electrics(const std::string& name, const actuator::Actuator& actuator, Index drive) {
    const SharedBus* bus = bus_of(static_cast<std::size_t>(drive));
    const actuator::PhaseModel model = actuator::phase_model_at(actuator, options_.conditions);
    const double temperature_K = winding_temperature_K(actuator, options_.conditions);
    const actuator::CheckBasis own(actuator, options_.conditions);
    const double rotor_kg_m2 = actuator::before_gears_kg_m2(actuator);
    const auto held = bus != nullptr ? held_region(own, options_.conditions) : nullptr;
    Eigen::MatrixXd found = Eigen::MatrixXd::Constant(6, motion_.samples(), kNone);
    double before_rad_s = 0.0;
    for (Index sample = 0; sample < motion_.samples(); ++sample) {
      const DriveInstant& at =
          demand().drives[static_cast<std::size_t>(drive)][static_cast<std::size_t>(sample)];
      const double speed_rad_s = own.counted_rad_s(at.speed_rad_s);
      const double motor_Nm = own.rotor
                                  .of(speed_rad_s, report_.torques_Nm(drive, sample),
                                      at.rotor_acceleration_rad_s2(rotor_kg_m2), before_rad_s)
                                  .motor_Nm;
      before_rad_s = speed_rad_s;
      const actuator::RegionLookup lookup =
          held ? actuator::RegionLookup(held, bus->voltage_V[sample], temperature_K) : own.lookup;
      const actuator::TorqueRange range = lookup.at(speed_rad_s, motor_Nm);
      if (!range.is_empty) {
        found.col(sample).segment<3>(3) << range.least_Nm, range.greatest_Nm,
            -range.excess_Nm(motor_Nm);
      }
      const auto asked = actuator::demand_at(actuator, model, temperature_K, speed_rad_s, motor_Nm);
      if (!asked) continue;
      found.col(sample).head<2>() << asked->current_A, asked->bus_power_W;
      found(2, sample) =
          bus != nullptr
              ? bus->voltage_V[sample]
              : actuator::bus_voltage_V(model.supply, asked->bus_power_W).value_or(kNone);
    }
    constexpr std::array kHeaders{"current_A",     "bus_power_W",   "bus_voltage_V",
                                  "torque_min_Nm", "torque_max_Nm", "torque_margin_Nm"};
    for (Index row = 0; row < found.rows(); ++row) {
      add_row(fmt::format("{}_{}", name, kHeaders[static_cast<std::size_t>(row)]), found, row);
    }
  }

  const SharedBus* bus_of(std::size_t drive) const {
    for (const SharedBus& bus : report_.buses) {
      if (std::find(bus.drives.begin(), bus.drives.end(), drive) != bus.drives.end()) return &bus;
    }
    return nullptr;
  }

  void add_body() {
    for (std::size_t i = 0; i < robot_.contacts.size(); ++i) {
      add_axes(robot_.contacts[i].name + "_force", "N", demand().forces_N,
               3 * static_cast<Index>(i));
    }
    add_residual();
    add_axes("center_of_mass", "m", demand().center_of_mass_m);
    add_axes("angular_momentum", "Nm_s", demand().angular_momentum_Nm_s);
    add_axes("centroidal_velocity", "rad_s", demand().angular_velocity_rad_s);
    add_row("composite_inertia_y_kg_m2", demand().lateral_inertia_kg_m2, 0);
    add_impacts();
  }

  void add_impacts() {
    VectorXd impacts = VectorXd::Zero(motion_.samples());
    Eigen::MatrixXd impulses_N_s =
        Eigen::MatrixXd::Zero(demand().forces_N.rows(), motion_.samples());
    for (const Jolt& jolt : demand().jolts) {
      impacts[jolt.sample] = 1.0;
      impulses_N_s.col(jolt.sample) = jolt.impulses_N_s;
    }
    for (std::size_t i = 0; i < robot_.contacts.size(); ++i) {
      add_axes(robot_.contacts[i].name + "_impulse", "N_s", impulses_N_s,
               3 * static_cast<Index>(i));
    }
    add("impact", impacts);
  }

  void add_residual() {
    const RowKinds& rows = demand().rows;
    const bool is_planar = rows.forces == 2;
    for (Index i = 0; i < rows.forces; ++i) {
      const auto axis = static_cast<std::size_t>(is_planar && i == 1 ? 2 : i);
      add_row(fmt::format("base_residual_force_{}_N", kAxes[axis]), demand().residual, i);
    }
    for (Index i = 0; i < rows.moments; ++i) {
      const auto axis = static_cast<std::size_t>(is_planar ? 1 : i);
      add_row(fmt::format("base_residual_moment_{}_Nm", kAxes[axis]), demand().residual,
              rows.forces + i);
    }
    Index row = rows.forces + rows.moments;
    for (std::size_t body = 1; body < robot_.tree.bodies.size(); ++body) {
      if (is_driven(body)) continue;
      const dynamics::Joint& joint = robot_.tree.bodies[body].joint;
      add_row(fmt::format("{}_residual_{}", joint.name, effort_of(joint)), demand().residual,
              row++);
    }
  }

  bool is_driven(std::size_t body) const {
    return std::any_of(robot_.drivetrains.begin(), robot_.drivetrains.end(),
                       [body](const Drivetrain& drivetrain) {
                         const auto& joints = drivetrain.joints;
                         return std::find(joints.begin(), joints.end(), body) != joints.end();
                       });
  }

  const Robot& robot_;
  const Motion& motion_;
  const CheckOptions& options_;
  const HopperReport& report_;
  Series series_;
};

}  // namespace

Series series_of(const Robot& robot, const Motion& motion, const CheckOptions& options,
                 const HopperReport& report, SeriesDetail detail) {
  return SeriesPass(robot, motion, options, report).run(detail);
}

namespace {

/// The shortest that reads back the same.
void append_number(double value, std::string& text) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), end.ptr);
}

/// Of each column the greatest finite size of all that have its unit.
std::vector<double> scales_of(const Series& series) {
  std::vector<std::string> headers;
  std::vector<double> sizes;
  for (const SeriesColumn& column : series) {
    headers.push_back(column.header);
    double greatest = 0.0;
    for (const double value : column.values) {
      if (std::isfinite(value)) greatest = std::max(greatest, std::abs(value));
    }
    sizes.push_back(greatest);
  }
  return io::unit_scales(headers, sizes);
}

}  // namespace

std::string series_csv(const Series& series) {
  std::string text;
  for (const SeriesColumn& column : series) {
    text += (text.empty() ? "" : ",") + column.header;
  }
  text += '\n';
  const std::vector<double> scales = scales_of(series);
  for (Index sample = 0; sample < series.front().values.size(); ++sample) {
    for (std::size_t i = 0; i < series.size(); ++i) {
      if (i > 0) text += ',';
      const double value = series[i].values[sample];
      if (std::isfinite(value)) append_number(io::without_noise(value, scales[i]), text);
    }
    text += '\n';
  }
  return text;
}

const VectorXd* find_column(const Series& series, const std::string& header) {
  const auto found = std::find_if(series.begin(), series.end(), [&](const SeriesColumn& column) {
    return column.header == header;
  });
  return found == series.end() ? nullptr : &found->values;
}

}  // namespace torquewright::hopper
