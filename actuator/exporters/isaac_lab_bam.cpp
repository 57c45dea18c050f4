// SPDX-License-Identifier: Apache-2.0
// Fields: Isaac Lab 3, source/isaaclab/isaaclab/actuators/actuator_bam_cfg.py @ 99551780
// (BamMotorCfg, BamActuatorCfg). Law: docs/source/concepts/actuators.rst @ 0120677c, "BAM servo
// model": tau = kt vin duty / R - kt^2 w / R, duty within +-max_pwm, held to actuator_effort_limit;
// friction of model m1, Coulomb's and viscous, is a constraint and a damping of MuJoCo Warp's. All
// at the joint: kt holds the gear. max_current 0 switches the firmware's own limit off, for the
// effort limit is that. What the firmware makes of an angle is the user's. N m, ohm, V, kg m^2.
#include <fmt/format.h>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/fit.hpp"
#include "actuator/exporters/line_law.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

Shape shape(const Subject& subject) { return fitted(subject, isaac_lab_bam, line_start(subject)); }

/// BamMotorCfg(...) on one line.
std::string motor(const Parallelogram& line, double bus_V, const JointFriction& friction) {
  const double constant_Nm_A = bus_V / line.no_load_speed_rad_s;
  return fmt::format(
      "BamMotorCfg(model=\"m1\", kt={}, resistance={}, error_gain=1.0, max_pwm=1.0, "
      "max_current=0.0, friction_base={}, friction_viscous={})",
      constant_Nm_A, constant_Nm_A * bus_V / line.stall_torque_Nm, friction.coulomb_Nm,
      friction.viscous_Nm_s_rad);
}

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const Parallelogram line = parallelogram_of(shape);
  const double bus_V = subject.bus_voltage_V();
  const PythonCall call{
      identifier(subject.actuator.name),
      {{"joint_names_expr", "[\"joint\"]", true},
       {"motor", motor(line, bus_V, subject.friction.value_or(JointFriction{})), false},
       python_argument("vin", bus_V),
       python_argument("actuator_effort_limit", line.greatest_torque_Nm),
       python_argument("joint_effort_limit", line.greatest_torque_Nm),
       armature_argument(subject.armature_kg_m2()),
       {"kp_fw", "1.0", true}}};
  return python_configurations(note, "isaaclab.actuators", "BamActuatorCfg", {&call, 1},
                               "BamMotorCfg");
}

}  // namespace

const Exporter isaac_lab_bam = {
    .name = "isaac-lab-bam",
    .simulator = "Isaac Lab 3, BamActuatorCfg",
    .source =
        "https://github.com/isaac-sim/IsaacLab actuators/actuator_bam_cfg.py @ 99551780; "
        "docs/source/concepts/actuators.rst @ 0120677c, BAM servo model",
    .advice =
        "A servo that is told angles: the duty is error_gain kp_fw times the error in rad, both "
        "your firmware's. Newton with MJWarp and use_newton_actuators=True alone. For commands "
        "that "
        "are torques take isaac-lab.",
    .parameters = kLineParameters,
    .shape = shape,
    .law = line_law,
    .write = write,
    .friction =
        {DryFriction::kOneValue,
         "friction_base is Coulomb's friction, a constraint of MJWarp's at rest and in motion, "
         "friction_viscous a damping of the joint (model m1). BAM's m2 and m5 hold more: identify "
         "--as bam writes them.",
         ""},
};

}  // namespace torquewright::actuator::exporters
