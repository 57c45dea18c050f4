// SPDX-License-Identifier: Apache-2.0
// Fields and law: mjlab, src/mjlab/actuator/dc_actuator.py at commit 018e7ee3 (DcMotorActuatorCfg:
// saturation_effort is the stall torque, velocity_limit the no-load speed, effort_limit the cap;
// the speed is clamped to the overspeed first) and the base class's target_names_expr, armature and
// frictionloss (mujocolab.github.io/mjlab/source/api/actuator.html). N m, rad/s, kg m^2.
#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/fit.hpp"
#include "actuator/exporters/line_law.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

Shape shape(const Subject& subject) { return fitted(subject, mjlab, line_start(subject)); }

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const Parallelogram line = parallelogram_of(shape);
  return python_configuration(note, "mjlab.actuator", "DcMotorActuatorCfg",
                              identifier(subject.actuator.name),
                              {{"target_names_expr", "(\"joint\",)", true},
                               python_argument("saturation_effort", line.stall_torque_Nm),
                               python_argument("velocity_limit", line.no_load_speed_rad_s),
                               python_argument("effort_limit", line.greatest_torque_Nm),
                               armature_argument(subject.armature_kg_m2()),
                               {"frictionloss", "0.0"},
                               {"stiffness", "0.0", true},
                               {"damping", "0.0", true}});
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
};

}  // namespace torquewright::actuator::exporters
