# origin
# knee D151 for MuJoCo Playground and MJX.
# Fields as in https://github.com/google-deepmind/mujoco_playground mujoco_playground/_src/mjx_env.py @ 1ab4cfd3; MuJoCo XML reference, body/joint and actuator/motor
# Fit: conservative (the region's table, drawn in by its interpolation error).
# Side: joint. Rating: peak. Bus voltage: 67.2 V. Winding temperature: 298.15 K.
# Friction included: gearbox efficiencies 1 driving, 1 back-driven. Do not also apply friction or an efficiency.
# Armature: 0.3688 kg m^2 = N^2 J, N = 20, J = 0.000922 kg m^2. Do not add the rotor to a link as well.
# MJCF is a joint and a <motor> whose ctrl is a torque in Nm: take over their attributes. step() in the place of mjx_env.step, or controls() before each mjx.step. Actions that are positions become torques first: kp (target - q) - kd q'.
# Left out: battery: none stated; the bus voltage is stiff
# Left out: thermal: none stated; the winding stays at its temperature
# Left out: inductance: none stated; voltage is lost over the resistance alone
# Left out: friction: no effects stated; losses are the gearbox's efficiencies
# Assumed: /motor/torque_constant_convention
# Assumed: /motor/resistance_ohm
# Assumed: /motor/pole_pairs
# Assumed: /motor/winding_temperature_K
# Assumed: /drive/continuous_current_A
# Assumed: /drive/modulation
# Assumed: /gearbox/forward_efficiency
# Assumed: /gearbox/backward_efficiency
# Worst torque error of the simulator with this file, |speed| up to 12.6875 rad/s:
#              bound               too optimistic                 too cautious
# speed > 0, driving                         none                         none
# speed > 0, braking                         none                         none
# speed < 0, braking                         none                         none
# speed < 0, driving                         none                         none
#     at rest, upper                         none                         none
#     at rest, lower                         none                         none
# 0 % of the torque-speed area that the simulator allows lies outside the region
clip = REGION.clip
limits = REGION.limits

MJCF = """<mujoco model="knee_D151">
  <compiler angle="radian"/>
  <worldbody>
    <body name="link">
      <joint name="joint" type="hinge" axis="0 0 1" armature="0.36879999999999996" damping="0" frictionloss="0"/>
      <geom type="sphere" size="0.05" mass="1"/>
    </body>
  </worldbody>
  <actuator>
    <motor name="knee_D151" joint="joint" gear="1" forcelimited="true" forcerange="-319.99999999999994 319.99999999999994"/>
  </actuator>
</mujoco>
"""


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
