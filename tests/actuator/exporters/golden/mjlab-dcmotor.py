# origin
# knee D151 for mjlab, BuiltinDcMotorActuatorCfg.
# Fields as in https://github.com/mujocolab/mjlab src/mjlab/actuator/builtin_actuator.py @ 803a18a0
# Fit: conservative (inside the region wherever that holds zero torque).
# Side: joint. Rating: peak. Bus voltage: 67.2 V. Winding temperature: 298.15 K.
# Friction included: gearbox efficiencies 1 driving, 1 back-driven. Do not also apply friction or an efficiency.
# Armature: 0.3688 kg m^2 = N^2 J, N = 20, J = 0.000922 kg m^2. Do not add the rotor to a link as well.
# MuJoCo's <dcmotor>: back-EMF is implicit. In VOLTAGE mode effort targets are volts; mode POSITION takes stiffness in V/rad and damping in V s/rad, which are yours.
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
from mjlab.actuator import BuiltinDcMotorActuatorCfg, DcMotorInputMode, DcMotorPhysicalParams

knee_D151 = BuiltinDcMotorActuatorCfg(
    target_names_expr=("joint",),  # yours
    motor_params=DcMotorPhysicalParams(kt=6.4, ke=6.4, resistance=0.28),
    mode=DcMotorInputMode.VOLTAGE,  # yours
    voltage_limit=67.2,
    effort_limit=319.99999999999994,
    armature=0.36879999999999996,
    frictionloss=0.0,
)
