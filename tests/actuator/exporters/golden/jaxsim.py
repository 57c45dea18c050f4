# origin
# knee D151 for JaxSim, ActuationParams.
# Fields as in https://github.com/ami-iit/jaxsim src/jaxsim/rbda/actuation/common.py @ e0e3286f
# Fit: conservative (inside the region wherever that holds zero torque).
# Side: joint. Rating: peak. Bus voltage: 67.2 V. Winding temperature: 298.15 K.
# Friction included: gearbox efficiencies 1 driving, 1 back-driven. Do not also apply friction or an efficiency.
# Armature: 0.3688 kg m^2 = N^2 J, N = 20, J = 0.000922 kg m^2. Do not add the rotor to a link as well.
# One set for every joint of a model. The same for driving and braking, and applied to commanded torque and joint friction together. The armature goes into the joint's parameters of the model.
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
# knee_speed_rad_s = 8.3125
# no_load_speed_rad_s = 10.5
# Worst torque error of the simulator with this file, |speed| up to 12.6875 rad/s:
#              bound               too optimistic                 too cautious
# speed > 0, driving                         none                         none
# speed > 0, braking      320 Nm at 12.6875 rad/s         320 Nm at 10.5 rad/s
# speed < 0, braking     320 Nm at -12.6875 rad/s        320 Nm at -10.5 rad/s
# speed < 0, driving                         none                         none
#     at rest, upper                         none                         none
#     at rest, lower                         none                         none
# 0 % of the torque-speed area that the simulator allows lies outside the region
from jaxsim.rbda.actuation import ActuationParams

knee_D151 = ActuationParams(
    torque_max=319.99999999999994,
    omega_th=8.3125,
    omega_max=10.5,
)
