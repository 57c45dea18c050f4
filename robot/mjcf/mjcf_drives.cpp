// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference, "actuator/general", "tendon/fixed", and actuator/exporters/
// mujoco.cpp, whose law this is.
#include "robot/mjcf/mjcf_drives.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <set>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/line_law.hpp"
#include "actuator/exporters/text.hpp"
#include "actuator/region/left_out.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/model/mechanism_reach.hpp"
#include "robot/xml/xml_text.hpp"

namespace torquewright::hopper {
namespace {

using actuator::FrictionPlace;
const actuator::Exporter& law_of_drives() { return actuator::exporters::mujoco; }

void read_region(const actuator::ExportedDrive& exported, Drive& drive) {
  const actuator::Subject& subject = exported.subject();
  const auto line = actuator::parallelogram_of(law_of_drives().shape(subject));
  drive.stall_torque_Nm = line.stall_torque_Nm;
  drive.no_load_speed_rad_s = line.no_load_speed_rad_s;
  drive.greatest_torque_Nm = line.greatest_torque_Nm;
  drive.bus_V = subject.bus_voltage_V();
  drive.is_curve = subject.actuator.envelope.has_value();
  if (drive.is_curve) drive.greatest_torque_Nm = subject.table.peak_torque_Nm;
  drive.friction = subject.friction.value_or(actuator::JointFriction{});
}

/// What MuJoCo's joint or tendon cannot hold of the friction, once for each document.
void note_friction(const actuator::ExportedDrive& exported, const std::string& file,
                   std::vector<std::string>& notes) {
  const actuator::Subject& subject = exported.subject();
  if (!subject.friction) {
    notes.push_back(fmt::format("{}: its gear locks itself: its friction is in its limits", file));
    return;
  }
  const std::vector<std::string> sentences = actuator::friction_not_held(
      *subject.whole, actuator::winding_temperature_K(*subject.whole, subject.conditions),
      subject.region.greatest_speed_rad_s(), false, subject.table.peak_torque_Nm);
  for (const std::string& sentence : sentences) {
    notes.push_back(fmt::format("{}: {}", file, sentence));
  }
}

/// With its friction where it is wanted, if its gear lets it.
actuator::ExportedDrive exported_drive(const actuator::Actuator& document, const std::string& file,
                                       FrictionPlace friction) {
  if (actuator::Region(document, {}).at(0.0).is_empty) {
    throw io::SpecError({{file, "", "no torque is possible at rest: there is no region to write"}});
  }
  if (friction == FrictionPlace::kJoint) {
    friction = actuator::usual_place(law_of_drives(), document, actuator::Side::kJoint);
  }
  return actuator::ExportedDrive(document, law_of_drives(), {.friction = friction});
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
  const auto write = [&](const char* key, double value) {
    if (value != 0) push(out, key, text_of(value));
  };
  write("damping", drive.friction.viscous_Nm_s_rad);
  write("frictionloss", drive.friction.coulomb_Nm);
  if (drive.friction.coulomb_Nm != 0) {
    push(out, "solreffriction", std::string(actuator::kFrictionConstraint));
  }
  for (std::size_t i = 0; i < drive.joints.size(); ++i) {
    out.OpenElement("joint");
    push(out, "joint", joint_name(robot, drive.joints[i]));
    push(out, "coef", text_of(drive.ratios[i]));
    out.CloseElement();
  }
  out.CloseElement();
}

/// <position kp kv> as MuJoCo makes it, and as 2.2.2 reads it, which knows no kv.
void write_servo(tinyxml2::XMLPrinter& out, const Robot& robot, const Drive& drive) {
  const bool couples = drive.joints.size() > 1;
  const double ratio = couples ? 1.0 : std::abs(drive.ratios.front());
  out.OpenElement("general");
  push(out, "name", drive.name);
  push(out, couples ? "tendon" : "joint",
       couples ? drive.name : joint_name(robot, drive.joints.front()));
  push(out, "gaintype", "fixed");
  push(out, "gainprm", text_of(drive.gains->kp_Nm_rad));
  push(out, "biastype", "affine");
  push(out, "biasprm", fmt::format("0 {} {}", -drive.gains->kp_Nm_rad, -drive.gains->kv_Nm_s_rad));
  if (!couples) {
    const dynamics::JointLimits& limits = robot.tree.bodies[drive.joints.front()].joint.limits;
    if (std::isfinite(limits.position_min) && std::isfinite(limits.position_max)) {
      push(out, "ctrllimited", "true");
      push(out, "ctrlrange", fmt::format("{} {}", limits.position_min, limits.position_max));
    }
  }
  const double most_Nm = ratio * drive.greatest_torque_Nm;
  push(out, "forcelimited", "true");
  push(out, "forcerange", fmt::format("{} {}", -most_Nm, most_Nm));
  out.CloseElement();
}

void write_general(tinyxml2::XMLPrinter& out, const Robot& robot, const Drive& drive) {
  const bool couples = drive.joints.size() > 1;
  if (drive.gains) return write_servo(out, robot, drive);
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

std::vector<Drive> drives_of(const Robot& robot, FrictionPlace friction, bool is_servo,
                             std::vector<std::string>& notes) {
  std::vector<Drive> drives;
  std::set<std::string> noted;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    const auto jacobian = jacobian_at_home(robot, drivetrain, notes);
    if (!jacobian) continue;
    for (std::size_t k = 0; k < drivetrain.actuators.size(); ++k) {
      Drive drive;
      drive.name = drivetrain.actuator_names[k];
      drive.joints = drivetrain.joints;
      const SmallVector row = jacobian->row(static_cast<Eigen::Index>(k)).transpose();
      drive.ratios.assign(row.data(), row.data() + row.size());
      const actuator::Actuator& document = drivetrain.actuators[k];
      const std::string& file = drivetrain.actuator_files[k];
      const actuator::ExportedDrive exported = exported_drive(document, file, friction);
      read_region(exported, drive);
      drive.inertia_kg_m2 = turned_at_output_kg_m2(drivetrain, k);
      if (friction == FrictionPlace::kJoint && noted.insert(file).second) {
        note_friction(exported, file, notes);
      }
      note_left_out(drivetrain, k, notes);
      if (drive.is_curve && !is_servo) {
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

void add_friction(const std::vector<Drive>& drives, dynamics::Tree& tree) {
  for (const Drive& drive : drives) {
    if (drive.joints.size() != 1) continue;
    dynamics::PassiveForces& passive = tree.bodies[drive.joints.front()].joint.passive;
    const double ratio = std::abs(drive.ratios.front());
    passive.dry_friction += ratio * drive.friction.coulomb_Nm;
    passive.damping += ratio * ratio * drive.friction.viscous_Nm_s_rad;
  }
}

void make_servos(const Robot& robot, const dynamics::Tree& tree, std::vector<Drive>& drives,
                 std::vector<std::string>& notes) {
  for (Drive& drive : drives) {
    const bool couples = drive.joints.size() > 1;
    const double inertia_kg_m2 =
        couples ? drive.inertia_kg_m2 : tree.bodies[drive.joints.front()].joint.reflected_inertia;
    if (!(inertia_kg_m2 > 0.0)) {
      throw io::SpecError(
          {{robot.name, "/mechanisms",
            fmt::format("{}: no gains, since neither a joint states a reflected inertia nor its "
                        "actuator one of the rotor: state /motor/rotor_inertia_kg_m2 there",
                        drive.name)}});
    }
    drive.gains = actuator::servo_gains(inertia_kg_m2);
    if (couples) {
      notes.push_back(fmt::format("{}: its control is its own angle, which is its tendon's length",
                                  drive.name));
    }
  }
  notes.push_back(fmt::format(
      "controls are angles in rad: kp = I w^2, kv = 2 z I w of the armature, w = 2 pi {:.4g} Hz, z "
      "= {:.4g} ({}); the force range knows no speed, so that at its no load speed a drive is off "
      "by all of it",
      actuator::kServo_Hz, actuator::kServoDamping, actuator::kServoSource));
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
