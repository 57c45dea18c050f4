// SPDX-License-Identifier: Apache-2.0
// Fields and law: mjlab, src/mjlab/actuator/dc_actuator.py at commit 018e7ee3 (DcMotorActuatorCfg:
// saturation_effort is the stall torque, velocity_limit the no-load speed, effort_limit the cap;
// the speed is clamped to the overspeed first) and the base class's target_names_expr, armature and
// frictionloss (mujocolab.github.io/mjlab/source/api/actuator.html). N m, rad/s, kg m^2.
// viscous_damping: actuator.py at the same commit, passive, as damping of the MuJoCo joint; None
// keeps that of the XML.
#include <fmt/format.h>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/fit.hpp"
#include "actuator/exporters/line_law.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

Shape shape(const Subject& subject) { return fitted(subject, mjlab, line_start(subject)); }

/// `joints`: expressions, behind commas; the user's where no joints are known.
std::vector<PythonArgument> arguments(const std::string& joints, bool is_yours,
                                      std::span<const double> shape, double armature_kg_m2,
                                      const std::optional<JointFriction>& friction) {
  const Parallelogram line = parallelogram_of(shape);
  const JointFriction joint = friction.value_or(JointFriction{});
  const PythonArgument viscous = friction_argument("viscous_damping", joint.viscous_Nm_s_rad);
  return {{"target_names_expr", "(" + joints + ",)", is_yours},
          python_argument("saturation_effort", line.stall_torque_Nm),
          python_argument("velocity_limit", line.no_load_speed_rad_s),
          python_argument("effort_limit", line.greatest_torque_Nm),
          armature_argument(armature_kg_m2),
          friction_argument("frictionloss", joint.coulomb_Nm),
          friction ? viscous : PythonArgument{"viscous_damping", ""},
          {"stiffness", "0.0", true},
          {"damping", "0.0", true}};
}

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const PythonCall call{
      identifier(subject.actuator.name),
      arguments("\"joint\"", true, shape, subject.armature_kg_m2(), subject.friction)};
  return python_configurations(note, "mjlab.actuator", "DcMotorActuatorCfg", {&call, 1});
}

std::string write_all(std::span<const DriveEntry> entries, const std::vector<std::string>& note) {
  std::vector<PythonCall> calls;
  std::string names;
  for (const DriveEntry& entry : entries) {
    calls.push_back({entry.name, arguments(python_expressions(entry.joints), false, entry.shape,
                                           entry.armature_kg_m2, entry.friction)});
    names += fmt::format("    {},\n", entry.name);
  }
  return python_configurations(note, "mjlab.actuator", "DcMotorActuatorCfg", calls) +
         "\n# EntityArticulationInfoCfg(actuators=ACTUATORS)\nACTUATORS = (\n" + names + ")\n";
}

}  // namespace

const Exporter mjlab = {
    .name = "mjlab",
    .simulator = "mjlab, DcMotorActuatorCfg",
    .source = "https://github.com/mujocolab/mjlab src/mjlab/actuator/dc_actuator.py @ 018e7ee3",
    .advice =
        "mjlab warns where effort_limit exceeds saturation_effort; the law holds all the same.",
    .parameters = kLineParameters,
    .shape = shape,
    .law = line_law,
    .write = write,
    .write_all = write_all,
    .friction =
        {DryFriction::kOneValue,
         "frictionloss and viscous_damping become frictionloss and damping of the MuJoCo "
         "joint (src/mjlab/actuator/actuator.py @ 018e7ee3): Coulomb's friction at rest and "
         "in motion, a soft constraint.",
         ""},
};

}  // namespace torquewright::actuator::exporters
