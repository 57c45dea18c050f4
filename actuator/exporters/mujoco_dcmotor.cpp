// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference, "actuator/dcmotor", and doc/dcmotor/dcmotor.tex (tables of the
// MJCF attributes; "Stateless DC Motor"). Everything at the rotor: force = clip(K/R (v - K w),
// +-saturation[0]), then times gear; armature is scaled by gear^2. input="ff" (3.12, commit
// 2f1843f4) commands torque, for which the drive sets v within +-controller[5] (Vmax).
#include <fmt/format.h>

#include <cmath>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/fit.hpp"
#include "actuator/exporters/line_law.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

Shape shape(const Subject& subject) { return fitted(subject, mujoco_dcmotor, line_start(subject)); }

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const Parallelogram line = parallelogram_of(shape);
  const double bus_V = subject.bus_voltage_V();
  const double ratio = subject.ratio();
  const JointFriction friction = subject.friction.value_or(JointFriction{});
  // w0 = V / K and stall torque = K V / R, both at the rotor.
  const double constant_Nm_A = bus_V / (line.no_load_speed_rad_s * std::abs(ratio));
  const double resistance_ohm = constant_Nm_A * bus_V * std::abs(ratio) / line.stall_torque_Nm;
  return xml_comment(note) +
         fmt::format(R"(<mujoco model={0}>
  <compiler angle="radian"/>
  <worldbody>
    <body name="link">
      <joint name="joint" type="hinge" axis="0 0 1" damping="{7}" frictionloss="{8}"{9}/>
      <geom type="sphere" size="0.05" mass="1"/>
    </body>
  </worldbody>
  <actuator>
    <dcmotor name={0} joint="joint" gear="{1}" motorconst="{2} {2}" resistance="{3}"
      saturation="{4} 0 0" input="ff" controller="0 0 0 0 0 {5}"{6}/>
  </actuator>
</mujoco>
)",
                     xml_quoted(subject.actuator.name), ratio, constant_Nm_A, resistance_ohm,
                     line.greatest_torque_Nm / std::abs(ratio), bus_V,
                     armature_attribute(subject.armature_kg_m2() / (ratio * ratio)),
                     friction.viscous_Nm_s_rad, friction.coulomb_Nm,
                     friction_constraint(friction.coulomb_Nm));
}

}  // namespace

const Exporter mujoco_dcmotor = {
    .name = "mujoco-dcmotor",
    .simulator = "MuJoCo 3.12 and later, <dcmotor>",
    .source = "https://github.com/google-deepmind/mujoco doc/dcmotor/dcmotor.tex @ 1d33874b",
    .advice =
        "ctrl is the torque at the rotor in Nm (times gear at the joint); MuJoCo scales the "
        "rotor's "
        "armature by gear^2 itself. 3.7 to 3.11 read input and controller differently. The link is "
        "a stand-in.",
    .parameters = kLineParameters,
    .shape = shape,
    .law = line_law,
    .write = write,
    .friction = {DryFriction::kOneValue, kFrictionLoss, ""},
    .inertia_at_rotor = true,
};

}  // namespace torquewright::actuator::exporters
