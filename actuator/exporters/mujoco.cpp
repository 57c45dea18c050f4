// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference, "actuator/general" and "body/joint" (mujoco.readthedocs.io,
// XMLreference), as of 2.2.2 and unchanged in meaning since. Law: mj_fwdActuation of
// src/engine/engine_forward.c at commit 0041fdcb, which 2.2.2 obeys alike: force = gainprm[0] ctrl
// + biasprm[0] + biasprm[1] length + biasprm[2] velocity, ctrl clamped to ctrlrange first, force to
// forcerange last. Radians and SI by <compiler angle="radian">. Friction: body/joint, damping (N m
// s/rad) and frictionloss (N m), and "Computation", friction loss: a bound on a constraint that
// keeps the joint from moving. That constraint is soft: it looks ahead by its time constant, 0.02 s
// if nothing is said, and lets go of (or pushes) a joint that would come to rest within half of
// that. solreffriction asks for less than any step: solref is raised to two steps (option flag
// refsafe, on by default).
#include <fmt/format.h>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/fit.hpp"
#include "actuator/exporters/line_law.hpp"
#include "actuator/exporters/text.hpp"
#include "actuator/motor/servo_gains.hpp"

namespace torquewright::actuator::exporters {
namespace {

Shape shape(const Subject& subject) { return fitted(subject, mujoco, line_start(subject)); }

/// A <position> that may stand in the place of the <general>.
std::string servo(const Subject& subject, double greatest_torque_Nm) {
  const double inertia_kg_m2 = subject.armature_kg_m2();
  if (!(inertia_kg_m2 > 0.0)) {
    return "    <!-- For angles, <position>: no gains, the document states no inertia of the "
           "rotor. "
           "-->\n";
  }
  const ServoGains gains = servo_gains(inertia_kg_m2);
  return fmt::format(
      R"(    <!-- For angles, in the place of <general>; its force range knows no speed. kp = I w^2, kv = 2 z I w
      of the armature, w = 2 pi 10 Hz, z = 2 (mjlab, unitree_g1/g1_constants.py @ 0234b2e9):
    <position joint="joint" kp="{0}" kv="{1}" forcelimited="true" forcerange="{2} {3}"/>
      2.2.2 knows no kv: there it is added to the joint's damping. -->
)",
      gains.kp_Nm_rad, gains.kv_Nm_s_rad, -greatest_torque_Nm, greatest_torque_Nm);
}

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  const Parallelogram line = parallelogram_of(shape);
  const double bus_V = subject.bus_voltage_V();
  const double gain_Nm_V = line.stall_torque_Nm / bus_V;
  const double bias_Nm_s_rad = -line.stall_torque_Nm / line.no_load_speed_rad_s;
  const JointFriction friction = subject.friction.value_or(JointFriction{});
  return xml_comment(note) +
         fmt::format(
             R"(<mujoco model={0}>
  <compiler angle="radian"/>
  <worldbody>
    <body name="link">
      <joint name="joint" type="hinge" axis="0 0 1"{1} damping="{8}" frictionloss="{9}"{10}/>
      <geom type="sphere" size="0.05" mass="1"/>
    </body>
  </worldbody>
  <actuator>
    <general name={0} joint="joint" gear="1" gaintype="fixed" gainprm="{2}" biastype="affine"
      biasprm="0 0 {3}" ctrllimited="true" ctrlrange="{4} {5}" forcelimited="true" forcerange="{6} {7}"/>
{11}  </actuator>
</mujoco>
)",
             xml_quoted(subject.actuator.name), armature_attribute(subject.armature_kg_m2()),
             gain_Nm_V, bias_Nm_s_rad, -bus_V, bus_V, -line.greatest_torque_Nm,
             line.greatest_torque_Nm, friction.viscous_Nm_s_rad, friction.coulomb_Nm,
             friction_constraint(friction.coulomb_Nm), servo(subject, line.greatest_torque_Nm));
}

}  // namespace

const Exporter mujoco = {
    .name = "mujoco",
    .simulator = "MuJoCo 2.2.2 and later, <general>",
    .source =
        "https://github.com/google-deepmind/mujoco src/engine/engine_forward.c @ 0041fdcb "
        "(mj_fwdActuation); XML reference, actuator/general",
    .advice =
        "ctrl is the voltage in V. The link is a stand-in: take over the joint's attributes and "
        "the "
        "actuator.",
    .parameters = kLineParameters,
    .shape = shape,
    .law = line_law,
    .write = write,
    .friction = {DryFriction::kOneValue, kFrictionLoss, ""},
};

}  // namespace torquewright::actuator::exporters
