// SPDX-License-Identifier: Apache-2.0
// Fields and law: mjlab, src/mjlab/actuator/builtin_actuator.py @ 803a18a0
// (BuiltinDcMotorActuatorCfg, DcMotorPhysicalParams, DcMotorInputMode): tau = K (V - K w) / R,
// voltage_limit clamps V, effort_limit is MuJoCo's saturation; in VOLTAGE mode the effort target is
// in volts, in POSITION mode a PID of stiffness in V/rad and damping in V s/rad sets them.
// armature, frictionloss and viscous_damping are the joint's. All at the joint, gear 1. N m, ohm,
// V, kg m^2.
#include <fmt/format.h>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/fit.hpp"
#include "actuator/exporters/line_law.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

Shape shape(const Subject& subject) { return fitted(subject, mjlab_dcmotor, line_start(subject)); }

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const Parallelogram line = parallelogram_of(shape);
  const double bus_V = subject.bus_voltage_V();
  const double constant_Nm_A = bus_V / line.no_load_speed_rad_s;
  const JointFriction friction = subject.friction.value_or(JointFriction{});
  const PythonCall call{
      identifier(subject.actuator.name),
      {{"target_names_expr", "(\"joint\",)", true},
       {"motor_params",
        fmt::format("DcMotorPhysicalParams(kt={0}, ke={0}, resistance={1})", constant_Nm_A,
                    constant_Nm_A * bus_V / line.stall_torque_Nm),
        false},
       {"mode", "DcMotorInputMode.VOLTAGE", true},
       python_argument("voltage_limit", bus_V),
       python_argument("effort_limit", line.greatest_torque_Nm),
       armature_argument(subject.armature_kg_m2()),
       friction_argument("frictionloss", friction.coulomb_Nm),
       subject.friction ? friction_argument("viscous_damping", friction.viscous_Nm_s_rad)
                        : PythonArgument{"viscous_damping", ""}}};
  return python_configurations(note, "mjlab.actuator", "BuiltinDcMotorActuatorCfg", {&call, 1},
                               "DcMotorInputMode, DcMotorPhysicalParams");
}

}  // namespace

const Exporter mjlab_dcmotor = {
    .name = "mjlab-dcmotor",
    .simulator = "mjlab, BuiltinDcMotorActuatorCfg",
    .source =
        "https://github.com/mujocolab/mjlab src/mjlab/actuator/builtin_actuator.py @ 803a18a0",
    .advice =
        "MuJoCo's <dcmotor>: back-EMF is implicit. In VOLTAGE mode effort targets are volts; mode "
        "POSITION takes stiffness in V/rad and damping in V s/rad, which are yours.",
    .parameters = kLineParameters,
    .shape = shape,
    .law = line_law,
    .write = write,
    .friction =
        {DryFriction::kOneValue,
         "frictionloss and viscous_damping become frictionloss and damping of the MuJoCo "
         "joint (builtin_actuator.py @ 803a18a0): Coulomb's friction at rest and in motion, a soft "
         "constraint.",
         ""},
};

}  // namespace torquewright::actuator::exporters
