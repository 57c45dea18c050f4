# origin
# knee D151 for Isaac Lab 3, RemotizedPDActuatorCfg.
# Fields as in https://github.com/isaac-sim/IsaacLab actuators/actuator_pd_cfg.py @ 17ad46e1
# Fit: conservative (inside the region wherever that holds zero torque).
# Side: joint. Rating: peak. Bus voltage: 67.2 V. Winding temperature: 298.15 K.
# Friction included: gearbox efficiencies 1 driving, 1 back-driven. Do not also apply friction or an efficiency.
# Armature: 0.3688 kg m^2 = N^2 J, N = 20, J = 0.000922 kg m^2. Do not add the rotor to a link as well.
# Torque by the joint's angle, for linkages; by speed only the solver's joint_velocity_limit, that of the angle nearest to zero, where a backend enforces it: a box is not an operating region. Where the ratio does not change take isaac-lab.
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
# greatest_torque_Nm = 320
# greatest_speed_rad_s = 8.3125
# Worst torque error of the simulator with this file, |speed| up to 12.6875 rad/s:
#              bound               too optimistic                 too cautious
# speed > 0, driving                         none                         none
# speed > 0, braking                         none                         none
# speed < 0, braking                         none                         none
# speed < 0, driving                         none                         none
#     at rest, upper                         none                         none
#     at rest, lower                         none                         none
# 0 % of the torque-speed area that the simulator allows lies outside the region
# at speeds > 8.3125 rad/s the format sets no limit to the torque: it holds that such speeds are not reached
# at speeds < -8.3125 rad/s the format sets no limit to the torque: it holds that such speeds are not reached
from isaaclab.actuators import RemotizedPDActuatorCfg

knee_D151 = RemotizedPDActuatorCfg(
    joint_names_expr=["joint"],  # yours
    joint_parameter_lookup=[[-3.141592653589793, 20, 319.9999999999995], [3.141592653589793, 20, 319.9999999999995]],
    joint_effort_limit=319.9999999999995,
    joint_velocity_limit=8.3125,
    armature=0.36879999999999996,
    friction=0.0,
    dynamic_friction=0.0,
    viscous_friction=0.0,
    stiffness=0.0,  # yours
    damping=0.0,  # yours
)
