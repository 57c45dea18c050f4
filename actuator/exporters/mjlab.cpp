// SPDX-License-Identifier: Apache-2.0
// Fields and law: mjlab, src/mjlab/actuator/dc_actuator.py at commit 018e7ee3 (DcMotorActuatorCfg:
// saturation_effort is the stall torque, velocity_limit the no-load speed, effort_limit the cap;
// the speed is clamped to the overspeed first) and the base class's target_names_expr, armature and
// frictionloss (mujocolab.github.io/mjlab/source/api/actuator.html). N m, rad/s, kg m^2.
#include <fmt/format.h>

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
  return line_comment(note, "# ") + fmt::format(R"(from mjlab.actuator import DcMotorActuatorCfg

{0} = DcMotorActuatorCfg(
    target_names_expr=("joint",),  # yours
    saturation_effort={1},
    velocity_limit={2},
    effort_limit={3},
    armature={4},
    frictionloss=0.0,
    stiffness=0.0,  # yours
    damping=0.0,  # yours
)
)",
                                                identifier(subject.actuator.name),
                                                line.stall_torque_Nm, line.no_load_speed_rad_s,
                                                line.greatest_torque_Nm, subject.armature_kg_m2());
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
