# origin
# knee D151 for Newton, ClampingDCMotor.
# Fields as in https://github.com/newton-physics/newton newton/_src/actuators/clamping/clamping_dc_motor.py @ 80c0da73a
# Fit: conservative (inside the region wherever that holds zero torque).
# Side: joint. Rating: peak. Bus voltage: 67.2 V. Winding temperature: 298.15 K.
# Friction included: gearbox efficiencies 1 driving, 1 back-driven. Do not also apply friction or an efficiency.
# Armature: 0.3688 kg m^2 = N^2 J, N = 20, J = 0.000922 kg m^2. Do not add the rotor to a link as well.
# Newton of before that commit (23 April 2026) does not clamp the speed: past the overspeed its limits cross.
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
from newton.actuators import ClampingDCMotor, ControllerPD


def add_knee_D151(builder, joint, kp=0.0, kd=0.0, strength=1.0):
    """Adds the actuator to a newton.ModelBuilder, at the index of a joint of one degree of freedom.

    strength: a factor on the torque that the motor makes within its law.
    """
    dof = builder.joint_qd_start[joint]
    builder.add_actuator(
        ControllerPD,
        index=dof,
        pos_index=builder.joint_q_start[joint],
        kp=strength * kp,
        kd=strength * kd,
        clamping=[
            (
                ClampingDCMotor,
                {
                    "saturation_effort": strength * 1536,
                    "velocity_limit": 10.5,
                    "max_motor_effort": strength * 319.99999999999994,
                },
            )
        ],
    )
    builder.joint_armature[dof] = 0.36879999999999996
