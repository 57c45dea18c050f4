// SPDX-License-Identifier: Apache-2.0
// Fields: Isaac Lab, docs/source/concepts/actuators.rst at commit 0120677c ("DCMotor":
// saturation_effort is the stall torque, actuator_velocity_limit the no-load speed; "Explicit
// groups keep the solver effort limit": joint_effort_limit at least actuator_effort_limit). Law:
// DCMotor._clip_effort in actuator_pd.py: the speed is clamped to +-w0 (1 + cap / stall) first, so
// that past it both limits are the cap against the motion. N m, rad/s, kg m^2.
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
  return python_configuration(note, "isaaclab.actuators", "DCMotorCfg",
                              identifier(subject.actuator.name),
                              {{"joint_names_expr", "[\"joint\"]", true},
                               python_argument("saturation_effort", line.stall_torque_Nm),
                               python_argument("actuator_velocity_limit", line.no_load_speed_rad_s),
                               python_argument("actuator_effort_limit", line.greatest_torque_Nm),
                               python_argument("joint_effort_limit", line.greatest_torque_Nm),
                               armature_argument(subject.armature_kg_m2()),
                               {"friction", "0.0"},
                               {"dynamic_friction", "0.0"},
                               {"viscous_friction", "0.0"},
                               {"stiffness", "0.0", true},
                               {"damping", "0.0", true}});
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
