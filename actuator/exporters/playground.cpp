// SPDX-License-Identifier: Apache-2.0
// MJCF: MuJoCo's XML reference, body/joint (armature, damping, frictionloss, solreffriction) and
// actuator/motor. Law: MuJoCo Playground, mujoco_playground/_src/mjx_env.py @ 1ab4cfd3, step: in
// each of n_substeps data.replace(ctrl=action), then mjx.step, in jax.lax.scan; here with the
// region between the two, at the speeds of each substep. N m, rad/s, kg m^2.
#include <fmt/format.h>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/python_module.hpp"
#include "actuator/exporters/table_law.hpp"
#include "actuator/exporters/text.hpp"

namespace torquewright::actuator::exporters {
namespace {

/// A joint and its motor, whose control is a torque in N m.
std::string mjcf(const Subject& subject) {
  const JointFriction friction = subject.friction.value_or(JointFriction{});
  const std::string name = identifier(subject.actuator.name);
  return fmt::format(R"(<mujoco model="{0}">
  <compiler angle="radian"/>
  <worldbody>
    <body name="link">
      <joint name="joint" type="hinge" axis="0 0 1"{1} damping="{2}" frictionloss="{3}"{4}/>
      <geom type="sphere" size="0.05" mass="1"/>
    </body>
  </worldbody>
  <actuator>
    <motor name="{0}" joint="joint" gear="1" forcelimited="true" forcerange="{5} {6}"/>
  </actuator>
</mujoco>
)",
                     name, armature_attribute(subject.armature_kg_m2()), friction.viscous_Nm_s_rad,
                     friction.coulomb_Nm, friction_constraint(friction.coulomb_Nm),
                     -subject.table.peak_torque_Nm, subject.table.peak_torque_Nm);
}

constexpr std::string_view kStep = R"(

def controls(torques, velocities, voltage=None, temperature=None):
    """What the motors can have of the torques [Nm] at the speeds [rad/s]: their ctrl."""
    return REGION.clip(torques, velocities, voltage, temperature)


def step(model, data, torques, motors, dofs, n_substeps=1):
    """MuJoCo Playground's mjx_env.step, with the motors' limits at the speeds of each substep.

    motors are places in ctrl, dofs those of their joints in qvel; other controls stay as they are.
    """
    import jax
    from mujoco import mjx

    def single_step(data, _):
        within = controls(torques, data.qvel[dofs])
        data = data.replace(ctrl=data.ctrl.at[motors].set(within))
        return mjx.step(model, data), None

    return jax.lax.scan(single_step, data, (), n_substeps)[0]
)";

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  return python_module(
      subject, shape, note,
      {.methods = "",
       .functions = "\nMJCF = \"\"\"" + mjcf(subject) + "\"\"\"\n" + std::string(kStep)});
}

}  // namespace

const Exporter playground = {
    .name = "playground",
    .simulator = "MuJoCo Playground and MJX",
    .source =
        "https://github.com/google-deepmind/mujoco_playground mujoco_playground/_src/mjx_env.py @ "
        "1ab4cfd3; MuJoCo XML reference, body/joint and actuator/motor",
    .advice =
        "MJCF is a joint and a <motor> whose ctrl is a torque in Nm: take over their attributes. "
        "step() in the place of mjx_env.step, or controls() before each mjx.step. Actions that "
        "are positions become torques first: kp (target - q) - kd q'.",
    .parameters = {},
    .shape = table_shape,
    .law = table_law,
    .write = write,
    .friction = {DryFriction::kOneValue, kFrictionLoss, ""},
};

}  // namespace torquewright::actuator::exporters
