// SPDX-License-Identifier: Apache-2.0
// Fields and law: Newton, newton/_src/actuators/clamping/clamping_dc_motor.py at commit 1f5efb33:
//   effort_max(v) = min(saturation_effort (1 - v / velocity_limit), max_motor_effort)
//   effort_min(v) = max(saturation_effort (-1 - v / velocity_limit), -max_motor_effort)
// without clamping the speed, so that past the overspeed effort_max < effort_min. The builder's
// call is the one in Newton's own tests. N m, rad/s, kg m^2.
#include <fmt/format.h>

#include <algorithm>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/fit.hpp"
#include "actuator/exporters/line_law.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

Shape shape(const Subject& subject) { return fitted(subject, newton, line_start(subject)); }

TorqueLimits law(std::span<const double> shape, double speed_rad_s) {
  const Parallelogram line = parallelogram_of(shape);
  const double share = speed_rad_s / line.no_load_speed_rad_s;
  return {std::max(line.stall_torque_Nm * (-1.0 - share), -line.greatest_torque_Nm),
          std::min(line.stall_torque_Nm * (1.0 - share), line.greatest_torque_Nm)};
}

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const Parallelogram line = parallelogram_of(shape);
  return line_comment(note, "# ") +
         fmt::format(R"(from newton.actuators import ClampingDCMotor, ControllerPD


def add_{0}(builder, dof, kp=0.0, kd=0.0):
    """Adds the actuator to a newton.ModelBuilder, at the index of a joint's degree of freedom."""
    builder.add_actuator(
        ControllerPD,
        index=dof,
        kp=kp,
        kd=kd,
        clamping=[
            (
                ClampingDCMotor,
                {{
                    "saturation_effort": {1},
                    "velocity_limit": {2},
                    "max_motor_effort": {3},
                }},
            )
        ],
    )
    builder.joint_armature[dof] = {4}
)",
                     identifier(subject.actuator.name), line.stall_torque_Nm,
                     line.no_load_speed_rad_s, line.greatest_torque_Nm, subject.armature_kg_m2());
}

}  // namespace

const Exporter newton = {
    .name = "newton",
    .simulator = "Newton, ClampingDCMotor",
    .source =
        "https://github.com/newton-physics/newton "
        "newton/_src/actuators/clamping/clamping_dc_motor.py @ 1f5efb33",
    .advice =
        "Where the limits cross, the clamp depends on the order of its comparisons: do not rely on "
        "it past the overspeed.",
    .parameters = kLineParameters,
    .shape = shape,
    .law = law,
    .write = write,
};

}  // namespace torquewright::actuator::exporters
