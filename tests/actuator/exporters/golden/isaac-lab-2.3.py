# origin
# knee D151 for Isaac Lab 2.3, DCMotorCfg.
# Fields as in https://github.com/isaac-sim/IsaacLab source/isaaclab/isaaclab/actuators/actuator_base_cfg.py of v2.3.2
# Fit: conservative (inside the region wherever that holds zero torque).
# Side: joint. Rating: peak. Bus voltage: 67.2 V. Winding temperature: 298.15 K.
# Friction included: gearbox efficiencies 1 driving, 1 back-driven. Do not also apply friction or an efficiency.
# Armature: 0.3688 kg m^2 = N^2 J, N = 20, J = 0.000922 kg m^2. Do not add the rotor to a link as well.
# Isaac Lab 3 calls these fields otherwise: isaac-lab.
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
# stall_torque_Nm = 1536
# no_load_speed_rad_s = 10.5
# greatest_torque_Nm = 320
# Worst torque error of the simulator with this file, |speed| up to 12.6875 rad/s:
#              bound               too optimistic                 too cautious
# speed > 0, driving                         none                         none
# speed > 0, braking                         none                         none
# speed < 0, braking                         none                         none
# speed < 0, driving                         none                         none
#     at rest, upper                         none                         none
#     at rest, lower                         none                         none
# 0 % of the torque-speed area that the simulator allows lies outside the region
from isaaclab.actuators import DCMotorCfg

knee_D151 = DCMotorCfg(
    joint_names_expr=["joint"],  # yours
    saturation_effort=1536,
    velocity_limit=10.5,
    effort_limit=319.99999999999994,
    effort_limit_sim=319.99999999999994,
    armature=0.36879999999999996,
    friction=0.0,
    dynamic_friction=0.0,
    viscous_friction=0.0,
    stiffness=0.0,  # yours
    damping=0.0,  # yours
)
