# origin
# knee D151 for Unitree RL Lab, UnitreeActuatorCfg.
# Fields as in https://github.com/Milad-Rakhsha/unitree_rl_lab unitree_actuators.py @ b4430e63, a fork
# Fit: conservative (inside the region wherever that holds zero torque).
# Side: joint. Rating: peak. Bus voltage: 67.2 V. Winding temperature: 298.15 K.
# Friction included: gearbox efficiencies 1 driving, 1 back-driven. Do not also apply friction or an efficiency.
# Armature: 0.3688 kg m^2 = N^2 J, N = 20, J = 0.000922 kg m^2. Do not add the rotor to a link as well.
# Braking falls with driving from X1 on and ends at X2, where a motor brakes fully. mjlab's names: X1 velocity_at_full_effort, X2 velocity_at_zero_effort, Y1 drive_effort_limit, Y2 brake_effort_limit, Fs static_friction, Fd dynamic_friction.
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
# knee_speed_rad_s = 8.3125
# no_load_speed_rad_s = 10.5
# drive_torque_Nm = 320
# brake_torque_Nm = 320
# Worst torque error of the simulator with this file, |speed| up to 12.6875 rad/s:
#              bound               too optimistic                 too cautious
# speed > 0, driving                         none                         none
# speed > 0, braking      320 Nm at 12.6875 rad/s         320 Nm at 10.5 rad/s
# speed < 0, braking     320 Nm at -12.6875 rad/s        320 Nm at -10.5 rad/s
# speed < 0, driving                         none                         none
#     at rest, upper                         none                         none
#     at rest, lower                         none                         none
# 0 % of the torque-speed area that the simulator allows lies outside the region
from unitree_rl_lab.assets.robots.unitree_actuators import UnitreeActuatorCfg

knee_D151 = UnitreeActuatorCfg(
    joint_names_expr=["joint"],  # yours
    X1=8.3125,
    X2=10.5,
    Y1=319.99999999999994,
    Y2=319.99999999999994,
    Fs=0.0,
    Fd=0.0,
    armature=0.36879999999999996,
    stiffness=0.0,  # yours
    damping=0.0,  # yours
)
