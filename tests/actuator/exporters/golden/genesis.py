# origin
# knee D151 for Genesis, control_dofs_force.
# Fields as in https://github.com/Genesis-Embodied-AI/Genesis genesis/engine/entities/rigid_entity/impl/entity_accessor.py @ 637426fb
# Fit: conservative (the region's table, drawn in by its interpolation error).
# Side: joint. Rating: peak. Bus voltage: 67.2 V. Winding temperature: 298.15 K.
# Friction included: gearbox efficiencies 1 driving, 1 back-driven. Do not also apply friction or an efficiency.
# Armature: 0.3688 kg m^2 = N^2 J, N = 20, J = 0.000922 kg m^2. Do not add the rotor to a link as well.
# set_up(entity, dofs) once after scene.build(), apply(entity, dofs, torques) before each scene.step(): a force that is controlled stays until the next, and its range knows no speed. With substeps the speed is that of the first.
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


def set_up(entity, dofs):
    """Once, of a scene that is built: what the joints have of this drive. dofs are local indices."""
    count = len(dofs)
    peak = REGION.peak_torque_Nm
    entity.set_dofs_force_range([-peak] * count, [peak] * count, dofs)
    if REGION.armature_kg_m2 is not None:
        entity.set_dofs_armature([REGION.armature_kg_m2] * count, dofs)


def apply(entity, dofs, torques, voltage=None, temperature=None):
    """Before each step: what the motors can have of the torques [Nm] at their speeds. Returns it.

    torques is a tensor of the shape that get_dofs_velocity gives.
    """
    within = REGION.clip(torques, entity.get_dofs_velocity(dofs), voltage, temperature)
    entity.control_dofs_force(within, dofs)
    return within
