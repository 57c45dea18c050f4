// SPDX-License-Identifier: Apache-2.0
// Fields: Isaac Lab, docs/source/concepts/actuators.rst at commit 0120677c ("DCMotor":
// saturation_effort is the stall torque, actuator_velocity_limit the no-load speed; "Explicit
// groups keep the solver effort limit": joint_effort_limit at least actuator_effort_limit). Law:
// DCMotor._clip_effort in actuator_pd.py: the speed is clamped to +-w0 (1 + cap / stall) first, so
// that past it both limits are the cap against the motion. N m, rad/s, kg m^2.
#include <fmt/format.h>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/fit.hpp"
#include "actuator/exporters/line_law.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

Shape shape(const Subject& subject) { return fitted(subject, isaac_lab, line_start(subject)); }

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const Parallelogram line = parallelogram_of(shape);
  return line_comment(note, "# ") + fmt::format(R"(from isaaclab.actuators import DCMotorCfg

{0} = DCMotorCfg(
    joint_names_expr=["joint"],  # yours
    saturation_effort={1},
    actuator_velocity_limit={2},
    actuator_effort_limit={3},
    joint_effort_limit={3},
    armature={4},
    friction=0.0,
    dynamic_friction=0.0,
    viscous_friction=0.0,
    stiffness=0.0,  # yours
    damping=0.0,  # yours
)
)",
                                                identifier(subject.actuator.name),
                                                line.stall_torque_Nm, line.no_load_speed_rad_s,
                                                line.greatest_torque_Nm, subject.armature_kg_m2());
}

}  // namespace

const Exporter isaac_lab = {
    .name = "isaac-lab",
    .simulator = "Isaac Lab 3, DCMotorCfg",
    .source = "https://github.com/isaac-sim/IsaacLab docs/source/concepts/actuators.rst @ 0120677c",
    .advice =
        "Before Isaac Lab 3 the fields are effort_limit and velocity_limit; before pull request "
        "2300 "
        "(April 2025) braking past the no-load speed was forced to zero.",
    .parameters = kLineParameters,
    .shape = shape,
    .law = line_law,
    .write = write,
};

}  // namespace torquewright::actuator::exporters
