# origin
# knee D151 for Isaac Gym Preview 4, GymDofProperties.
# Fields as in https://forums.developer.nvidia.com/t/carb-gymdofproperties-documentation/196552; https://github.com/isaac-sim/IsaacGymEnvs factory_base.py @ 18465747
# Fit: conservative (the region's table, drawn in by its interpolation error).
# Side: joint. Rating: peak. Bus voltage: 67.2 V. Winding temperature: 298.15 K.
# Friction included: gearbox efficiencies 1 driving, 1 back-driven. Do not also apply friction or an efficiency.
# Armature: 0.3688 kg m^2 = N^2 J, N = 20, J = 0.000922 kg m^2. Do not add the rotor to a link as well.
# set_dof_properties(properties, dofs) once for each actor; efforts(torques, velocities) before each simulate, as in legged_gym's _compute_torques. Import isaacgym before torch.
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


def set_dof_properties(properties, dofs):
    """Writes what the simulator's joints have of this drive into an array of DOF properties.

    properties is what get_asset_dof_properties gives, dofs are indices; hand it to
    set_actor_dof_properties. Returns it.
    """
    from isaacgym import gymapi

    values = {
        "driveMode": int(gymapi.DOF_MODE_EFFORT),
        "effort": REGION.peak_torque_Nm,
        "velocity": 2.0 * REGION.table["speed_rad_s"][-1],  # no limit of the motor's
        "stiffness": 0.0,
        "damping": 0.0,
        "friction": 0.0,
    }
    if REGION.armature_kg_m2 is not None:
        values["armature"] = REGION.armature_kg_m2
    for name, value in values.items():
        for dof in dofs:
            properties[name][dof] = value
    return properties


def efforts(torques, velocities, voltage=None, temperature=None):
    """What set_dof_actuation_force_tensor is to have [Nm] of torques [Nm] that are commanded.

    Tensors of one shape, velocities [rad/s]; before each step of the simulation.
    """
    return REGION.clip(torques, velocities, voltage, temperature)
