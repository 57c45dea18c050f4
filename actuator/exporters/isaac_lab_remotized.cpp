// SPDX-License-Identifier: Apache-2.0
// Fields: Isaac Lab, source/isaaclab/isaaclab/actuators/actuator_pd_cfg.py @ 17ad46e1,
// RemotizedPDActuatorCfg: joint_parameter_lookup, rows of joint angle (rad), transmission ratio
// (in/out) and output torque (N m). Law: RemotizedPDActuator in actuator_pd.py @ eafe554d: the
// effort is clipped to +-torque, interpolated at the joint's angle, whatever the speed: a box, as
// of URDF. Its own effort and velocity limits are set to infinity; joint_velocity_limit is the
// solver's (actuator_base_cfg.py @ 01ff1d86: "requested", "enforcement is backend-dependent").
// Friction as of isaac_lab.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

constexpr ShapeParameter kParameters[] = {{"greatest_torque_Nm"}, {"greatest_speed_rad_s"}};

Shape shape(const Subject& subject) { return urdf.shape(subject); }

TorqueLimits law(std::span<const double> shape, double speed_rad_s) {
  return urdf.law(shape, speed_rad_s);
}

/// A list of rows; without postures the same torque at every angle.
std::string lookup(std::span<const PosturePoint> postures, double ratio, double torque_Nm) {
  if (postures.empty()) {
    return fmt::format("[[{0}, {1}, {2}], [{3}, {1}, {2}]]", -std::numbers::pi, ratio, torque_Nm,
                       std::numbers::pi);
  }
  std::string text = "[";
  for (const PosturePoint& at : postures) {
    text += fmt::format("\n        [{}, {}, {}],", at.position_rad, at.ratio, at.torque_Nm);
  }
  return text + "\n    ]";
}

/// `joints`: expressions, behind commas; the user's where no joints are known.
std::vector<PythonArgument> arguments(const std::string& joints, bool is_yours, std::string rows,
                                      double most_Nm, double speed_rad_s, double armature_kg_m2,
                                      const JointFriction& friction) {
  return {{"joint_names_expr", "[" + joints + "]", is_yours},
          {"joint_parameter_lookup", std::move(rows), false},
          python_argument("joint_effort_limit", most_Nm),
          python_argument("joint_velocity_limit", speed_rad_s),
          armature_argument(armature_kg_m2),
          friction_argument("friction", friction.breakaway_Nm),
          friction_argument("dynamic_friction", friction.coulomb_Nm),
          friction_argument("viscous_friction", friction.viscous_Nm_s_rad),
          {"stiffness", "0.0", true},
          {"damping", "0.0", true}};
}

constexpr const char* kClass = "RemotizedPDActuatorCfg";

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const PythonCall call{
      identifier(subject.actuator.name),
      arguments("\"joint\"", true, lookup({}, subject.ratio(), shape[0]), shape[0], shape[1],
                subject.armature_kg_m2(), subject.friction.value_or(JointFriction{}))};
  return python_configurations(note, "isaaclab.actuators", kClass, {&call, 1});
}

std::string write_all(std::span<const DriveEntry> entries, const std::vector<std::string>& note) {
  std::vector<PythonCall> calls;
  std::string names;
  for (const DriveEntry& entry : entries) {
    double most_Nm = entry.shape[0];
    for (const PosturePoint& at : entry.postures) most_Nm = std::max(most_Nm, at.torque_Nm);
    calls.push_back(
        {entry.name, arguments(python_expressions(entry.joints), false,
                               lookup(entry.postures, 1.0, entry.shape[0]), most_Nm, entry.shape[1],
                               entry.armature_kg_m2, entry.friction.value_or(JointFriction{}))});
    names += fmt::format("    \"{0}\": {0},\n", entry.name);
  }
  return python_configurations(note, "isaaclab.actuators", kClass, calls) +
         "\n# ArticulationCfg(actuators=ACTUATORS)\nACTUATORS = {\n" + names + "}\n";
}

}  // namespace

const Exporter isaac_lab_remotized = {
    .name = "isaac-lab-remotized",
    .simulator = "Isaac Lab 3, RemotizedPDActuatorCfg",
    .source = "https://github.com/isaac-sim/IsaacLab actuators/actuator_pd_cfg.py @ 17ad46e1",
    .advice =
        "Torque by the joint's angle, for linkages; by speed only the solver's "
        "joint_velocity_limit, "
        "that of the angle nearest to zero, where a backend enforces it: a box is not an operating "
        "region. Where the ratio does not change take isaac-lab.",
    .parameters = kParameters,
    .shape = shape,
    .law = law,
    .write = write,
    .write_all = write_all,
    .friction =
        {DryFriction::kBreakaway,
         "friction is the effort at rest, dynamic_friction that in motion, viscous_friction "
         "per speed, all at the joint (docs/source/concepts/actuators.rst @ 0120677c, "
         "Friction; pull request 7412).",
         ""},
    .takes_postures = true,
};

}  // namespace torquewright::actuator::exporters
