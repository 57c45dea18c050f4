// origin
// knee D151 for RaiSim 1, C++ callback.
// Fields as in https://github.com/raisimTech/raisimLib raisim/linux/include/raisim/object/ArticulatedSystem/ArticulatedSystem.hpp @ 9bcf414b
// Fit: conservative (the region's table, drawn in by its interpolation error).
// Side: joint. Rating: peak. Bus voltage: 67.2 V. Winding temperature: 298.15 K.
// Friction included: gearbox efficiencies 1 driving, 1 back-driven. Do not also apply friction or an efficiency.
// Armature: 0.3688 kg m^2 = N^2 J, N = 20, J = 0.000922 kg m^2. Do not add the rotor to a link as well.
// Limits hold for a whole step at the speed of its start, and for torques that you command: RaiSim's own PD controller goes past them. Set the armature by <dynamics rotor_inertia=.../> in the URDF.
// Left out: battery: none stated; the bus voltage is stiff
// Left out: thermal: none stated; the winding stays at its temperature
// Left out: inductance: none stated; voltage is lost over the resistance alone
// Left out: friction: no effects stated; losses are the gearbox's efficiencies
// Assumed: /motor/torque_constant_convention
// Assumed: /motor/resistance_ohm
// Assumed: /motor/pole_pairs
// Assumed: /motor/winding_temperature_K
// Assumed: /drive/continuous_current_A
// Assumed: /drive/modulation
// Assumed: /gearbox/forward_efficiency
// Assumed: /gearbox/backward_efficiency
// Worst torque error of the simulator with this file, |speed| up to 12.6875 rad/s:
//              bound               too optimistic                 too cautious
// speed > 0, driving                         none                         none
// speed > 0, braking                         none                         none
// speed < 0, braking                         none                         none
// speed < 0, driving                         none                         none
//     at rest, upper                         none                         none
//     at rest, lower                         none                         none
// 0 % of the torque-speed area that the simulator allows lies outside the region
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <raisim/World.hpp>
#include <utility>

/// Least and greatest torque [Nm] at a speed [rad/s].
inline std::pair<double, double> knee_D151_torque_limits(double speed) {
  static constexpr double kSpeed[] = {
      -12.687499999999801, -12.158854166666478, -11.630208333333151, -11.101562499999824,
      -10.5729166666665, -10.500000000000298, -10.499999999999337, -10.044270833333176,
      -9.51562499999985, -8.986979166666526, -8.4583333333332, -8.312500000000798,
      -8.312499999999837, -7.929687499999876, -7.401041666666551, -6.872395833333226,
      -6.3437499999999005, -5.8151041666665755, -5.28645833333325, -4.757812499999925,
      -4.2291666666666, -3.7005208333332753, -3.1718749999999503, -2.643229166666625,
      -2.1145833333333, -1.5859374999999751, -1.05729166666665, -0.528645833333325,
      0, 0.528645833333325, 1.05729166666665, 1.5859374999999751,
      2.1145833333333, 2.643229166666625, 3.1718749999999503, 3.7005208333332753,
      4.2291666666666, 4.757812499999925, 5.28645833333325, 5.8151041666665755,
      6.3437499999999005, 6.872395833333226, 7.401041666666551, 7.929687499999876,
      8.312499999999837, 8.312500000000798, 8.4583333333332, 8.986979166666526,
      9.51562499999985, 10.044270833333176, 10.499999999999337, 10.500000000000298,
      10.5729166666665, 11.101562499999824, 11.630208333333151, 12.158854166666478,
      12.687499999999801,};
  static constexpr double kLeast[] = {
      319.9999999999684, 242.66666666663656, 165.33333333330404, 87.99999999997154,
      10.666666666639667, 4.111146684888538e-11, -9.971955147319075e-11, -66.66666666669252,
      -144.0000000000244, -221.33333333335662, -298.6666666666886, -319.9999999998859,
      -319.9999999999995, -319.9999999999995, -319.9999999999995, -319.9999999999995,
      -319.9999999999995, -319.9999999999995, -319.9999999999995, -319.9999999999995,
      -319.9999999999995, -319.9999999999995, -319.9999999999995, -319.9999999999995,
      -319.9999999999995, -319.9999999999995, -319.9999999999995, -319.9999999999995,
      -319.9999999999995, -319.9999999999995, -319.9999999999995, -319.9999999999995,
      -319.9999999999995, -319.9999999999995, -319.9999999999995, -319.9999999999995,
      -319.9999999999995, -319.9999999999995, -319.9999999999995, -319.9999999999995,
      -319.9999999999995, -319.9999999999995, -319.9999999999995, -319.9999999999995,
      -319.9999999999995, -319.9999999999995, -319.9999999999995, -319.9999999999995,
      -319.9999999999995, -319.9999999999995, -319.9999999999995, -319.9999999999995,
      -319.9999999999995, -319.9999999999995, -319.9999999999995, -319.9999999999995,
      -319.9999999999995,};
  static constexpr double kGreatest[] = {
      319.9999999999995, 319.9999999999995, 319.9999999999995, 319.9999999999995,
      319.9999999999995, 319.9999999999995, 319.9999999999995, 319.9999999999995,
      319.9999999999995, 319.9999999999995, 319.9999999999995, 319.9999999999995,
      319.9999999999995, 319.9999999999995, 319.9999999999995, 319.9999999999995,
      319.9999999999995, 319.9999999999995, 319.9999999999995, 319.9999999999995,
      319.9999999999995, 319.9999999999995, 319.9999999999995, 319.9999999999995,
      319.9999999999995, 319.9999999999995, 319.9999999999995, 319.9999999999995,
      319.9999999999995, 319.9999999999995, 319.9999999999995, 319.9999999999995,
      319.9999999999995, 319.9999999999995, 319.9999999999995, 319.9999999999995,
      319.9999999999995, 319.9999999999995, 319.9999999999995, 319.9999999999995,
      319.9999999999995, 319.9999999999995, 319.9999999999995, 319.9999999999995,
      319.9999999999995, 319.9999999998859, 298.6666666666886, 221.33333333335662,
      144.0000000000244, 66.66666666669252, 9.971955147319075e-11, -4.111146684888538e-11,
      -10.666666666639667, -87.99999999997154, -165.33333333330404, -242.66666666663656,
      -319.9999999999684,};
  constexpr int kRows = 57;
  if (speed == 0.0) return {-319.9999999999995, 319.9999999999995};
  const auto row = std::upper_bound(kSpeed, kSpeed + kRows, speed) - kSpeed;
  if (row == 0) return {kLeast[0], kGreatest[0]};
  if (row == kRows) return {kLeast[kRows - 1], kGreatest[kRows - 1]};
  const double share = (speed - kSpeed[row - 1]) / (kSpeed[row] - kSpeed[row - 1]);
  return {kLeast[row - 1] + share * (kLeast[row] - kLeast[row - 1]),
          kGreatest[row - 1] + share * (kGreatest[row] - kGreatest[row - 1])};
}

/// Call before every World::integrate(). `dof` counts as in the generalized velocity.
inline void limit_knee_D151(raisim::ArticulatedSystem& robot, int dof) {
  Eigen::VectorXd upper = robot.getActuationUpperLimits().e();
  Eigen::VectorXd lower = robot.getActuationLowerLimits().e();
  const auto [least, greatest] = knee_D151_torque_limits(robot.getGeneralizedVelocity().e()[dof]);
  upper[dof] = greatest;
  lower[dof] = least;
  robot.setActuationLimits(upper, lower);
}
