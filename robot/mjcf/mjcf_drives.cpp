// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference, "actuator/general", "tendon/fixed", and actuator/exporters/
// mujoco.cpp, whose law this is.
#include "robot/mjcf/mjcf_drives.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/line_law.hpp"
#include "actuator/region/left_out.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/model/mechanism_reach.hpp"
#include "robot/xml/xml_text.hpp"

namespace torquewright::hopper {
namespace {

void read_region(const actuator::Actuator& document, const std::string& file, Drive& drive) {
  const actuator::Actuator stated = actuator::as_laws_brake(document);
  const actuator::OperatingConditions conditions;
  const actuator::Region region(stated, conditions);
  if (region.at(0.0).is_empty) {
    throw io::SpecError({{file, "", "no torque is possible at rest: there is no region to write"}});
  }
  const actuator::MorTable table = actuator::mor_table(region);
  const actuator::Subject subject{stated, conditions, region, table};
  const auto line = actuator::parallelogram_of(actuator::exporters::mujoco.shape(subject));
  drive.stall_torque_Nm = line.stall_torque_Nm;
  drive.no_load_speed_rad_s = line.no_load_speed_rad_s;
  drive.greatest_torque_Nm = line.greatest_torque_Nm;
  drive.bus_V = subject.bus_voltage_V();
  drive.is_curve = stated.envelope.has_value();
  if (drive.is_curve) drive.greatest_torque_Nm = table.peak_torque_Nm;
}

/// Speeds of the drives over those of the joints; empty where the mechanism is singular at home.
std::optional<SmallMatrix> jacobian_at_home(const Robot& robot, const Drivetrain& drivetrain,
                                            std::vector<std::string>& notes) {
  if (const auto constant = drivetrain.mechanism->constant_jacobian()) return constant;
  const SmallVector home = home_posture_rad(robot.tree, drivetrain.joints);
  const auto transfer = drivetrain.mechanism->transfer(home, SmallVector::Zero(home.size()));
  const std::string names = fmt::format("{}", fmt::join(drivetrain.actuator_names, ", "));
  if (!transfer) {
    notes.push_back(
        fmt::format("{}: not driven, the mechanism is singular nearest to zero", names));
    return std::nullopt;
  }
  notes.push_back(
      fmt::format("{} drive by the mechanism's ratios where its joints are nearest to "
                  "zero: their change with posture is not held",
                  names));
  return transfer->jacobian;
}

void push(tinyxml2::XMLPrinter& out, const char* name, const std::string& value) {
  out.PushAttribute(name, value.c_str());
}

const std::string& joint_name(const Robot& robot, std::size_t body) {
  return robot.tree.bodies[body].joint.name;
}

void write_tendon(tinyxml2::XMLPrinter& out, const Robot& robot, const Drive& drive) {
  out.OpenElement("fixed");
  push(out, "name", drive.name);
  for (std::size_t i = 0; i < drive.joints.size(); ++i) {
    out.OpenElement("joint");
    push(out, "joint", joint_name(robot, drive.joints[i]));
    push(out, "coef", text_of(drive.ratios[i]));
    out.CloseElement();
  }
  out.CloseElement();
}

void write_general(tinyxml2::XMLPrinter& out, const Robot& robot, const Drive& drive) {
  const bool couples = drive.joints.size() > 1;
  out.OpenElement(drive.is_curve ? "motor" : "general");
  push(out, "name", drive.name);
  push(out, couples ? "tendon" : "joint",
       couples ? drive.name : joint_name(robot, drive.joints.front()));
  push(out, "gear", text_of(couples ? 1 : drive.ratios.front()));
  if (drive.is_curve) {
    const double most_Nm = drive.greatest_torque_Nm;
    push(out, "forcelimited", "true");
    push(out, "forcerange", fmt::format("{} {}", -most_Nm, most_Nm));
    out.CloseElement();
    return;
  }
  push(out, "gaintype", "fixed");
  push(out, "gainprm", text_of(drive.stall_torque_Nm / drive.bus_V));
  push(out, "biastype", "affine");
  push(out, "biasprm", fmt::format("0 0 {}", -drive.stall_torque_Nm / drive.no_load_speed_rad_s));
  push(out, "ctrllimited", "true");
  push(out, "ctrlrange", fmt::format("{} {}", -drive.bus_V, drive.bus_V));
  push(out, "forcelimited", "true");
  push(out, "forcerange",
       fmt::format("{} {}", -drive.greatest_torque_Nm, drive.greatest_torque_Nm));
  out.CloseElement();
}

void write_motor(tinyxml2::XMLPrinter& out, const dynamics::Joint& joint) {
  out.OpenElement("motor");
  push(out, "name", joint.name);
  push(out, "joint", joint.name);
  push(out, "forcelimited", "true");
  push(out, "forcerange", fmt::format("{} {}", -joint.limits.effort_max, joint.limits.effort_max));
  out.CloseElement();
}

/// What its drives' regions do not hold, by drive and effect.
void note_left_out(const Drivetrain& drivetrain, std::size_t index,
                   std::vector<std::string>& notes) {
  using actuator::Part;
  const Part part = drivetrain.joints_state_rotors ? Part::kRegion : Part::kCheck;
  for (const auto* effect : effects_left_out(drivetrain.actuators[index], part)) {
    notes.push_back(fmt::format("{}: left out: {}", drivetrain.actuator_names[index],
                                actuator::left_out_sentence(*effect)));
  }
}

}  // namespace

std::vector<Drive> drives_of(const Robot& robot, std::vector<std::string>& notes) {
  std::vector<Drive> drives;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    const auto jacobian = jacobian_at_home(robot, drivetrain, notes);
    if (!jacobian) continue;
    for (std::size_t k = 0; k < drivetrain.actuators.size(); ++k) {
      Drive drive;
      drive.name = drivetrain.actuator_names[k];
      drive.joints = drivetrain.joints;
      const SmallVector row = jacobian->row(static_cast<Eigen::Index>(k)).transpose();
      drive.ratios.assign(row.data(), row.data() + row.size());
      read_region(drivetrain.actuators[k], drivetrain.actuator_files[k], drive);
      note_left_out(drivetrain, k, notes);
      if (drive.is_curve) {
        notes.push_back(
            fmt::format("{}: its control is a torque in Nm, held to its peak; how its "
                        "curve falls with the speed is not held",
                        drive.name));
      }
      drives.push_back(std::move(drive));
    }
  }
  return drives;
}

void write_drives(tinyxml2::XMLPrinter& out, const Robot& robot, const std::vector<Drive>& drives) {
  out.OpenElement("tendon");
  for (const Drive& drive : drives) {
    if (drive.joints.size() > 1) write_tendon(out, robot, drive);
  }
  out.CloseElement();
  out.OpenElement("actuator");
  for (const Drive& drive : drives) write_general(out, robot, drive);
  for (std::size_t i = 1; i < robot.tree.bodies.size(); ++i) {
    const dynamics::Joint& joint = robot.tree.bodies[i].joint;
    if (std::isfinite(joint.limits.effort_max)) write_motor(out, joint);
  }
  out.CloseElement();
}

}  // namespace torquewright::hopper
