# origin
# knee D151 for PyBullet, TORQUE_CONTROL.
# Fields as in https://github.com/bulletphysics/bullet3 examples/pybullet/pybullet.c @ 8af62239; PyBullet Quickstart Guide, setJointMotorControl2
# Fit: conservative (the region's table, drawn in by its interpolation error).
# Side: joint. Rating: peak. Bus voltage: 67.2 V. Winding temperature: 298.15 K.
# Friction included: gearbox efficiencies 1 driving, 1 back-driven. Do not also apply friction or an efficiency.
# Armature: 0.3688 kg m^2 = N^2 J, N = 20, J = 0.000922 kg m^2. Do not add the rotor to a link as well.
# set_up(pybullet, body, joints) once, apply(pybullet, body, joints, torques) before each stepSimulation: a torque lasts one step. PyBullet has no armature: add it to the link's inertia about the axis (changeDynamics, localInertiaDiagonal). Bullet damps every body by 0.04 unless linearDamping and angularDamping are 0.
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


def set_up(bullet, body, joints):
    """Once: PyBullet's own velocity motor of each joint becomes its dry friction.

    bullet is the module pybullet, or a client of bullet_client; joints are indices.
    """
    for joint in joints:
        bullet.setJointMotorControl2(
            body, joint, bullet.VELOCITY_CONTROL, targetVelocity=0.0, force=0
        )


def apply(bullet, body, joints, torques, voltage=None, temperature=None):
    """Before each step: what the motors can have of the torques [Nm] at their speeds. Returns it."""
    import numpy

    velocities = numpy.asarray([state[1] for state in bullet.getJointStates(body, joints)])
    within = REGION.clip(numpy.asarray(torques, dtype=float), velocities, voltage, temperature)
    bullet.setJointMotorControlArray(body, joints, bullet.TORQUE_CONTROL, forces=within.tolist())
    return within
