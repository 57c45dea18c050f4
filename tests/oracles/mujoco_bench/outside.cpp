// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/mujoco_bench/outside.hpp"

#include <numbers>

namespace torquewright::oracles::mujoco_bench {
namespace {

const std::vector<std::string> kSensor = {"dynamometer"};
const Demand kTorqueAndCurrent = {.loads = kSensor, .drive = "current"};
const Demand kTwoEncoders = {.loads = kSensor, .two_encoders = true, .drive = "current"};

double peak_A(const Situation& it) { return it.stated.motor.peak_current_A; }

Effect spring(double scale, const Situation& it, Draws draws) {
  const bool hangs = it.stated.load.type == "pendulum";
  const double span = hangs ? 2 : it.top_speed_rad_s;
  return {"parallel_spring",
          {{"stiffness_Nm_rad", 0.3 * scale * it.peak_torque_Nm() / span},
           {"rest_rad", draws.uniform(-0.3, 0.3)}}};
}

Effect stop(double scale, const Situation& it, Draws draws) {
  return {"end_stop",
          {{"stop_rad", draws.uniform(0.6, 1.1)},
           {"stiffness_Nm_rad", 4 * scale * it.peak_torque_Nm()}}};
}

Effect eccentricity(double scale, const Situation&, Draws draws) {
  return {"encoder_eccentricity",
          {{"amplitude_rad", 0.03 * scale},
           {"phase_rad", draws.uniform(-std::numbers::pi, std::numbers::pi)}}};
}

constexpr double kLines = 32;

Effect interpolation(double scale, const Situation&, Draws) {
  return {"encoder_interpolation", {{"amplitude_rad", 0.01 * scale}, {"order", kLines}}};
}

Effect gain_by_sign(double scale, const Situation&, Draws draws) {
  return {"current_gain_by_sign", {{"share", draws.sign() * 0.25 * scale}}};
}

Effect dead_band(double scale, const Situation& it, Draws) {
  return {"current_dead_band", {{"width_A", 0.2 * scale * peak_A(it)}}};
}

Effect growing_friction(double scale, const Situation& it, Draws) {
  return {"friction_growing_with_time", {{"growth_Nm_s", 0.03 * scale * it.peak_torque_Nm()}}};
}

Effect slip(double scale, const Situation& it, Draws) {
  return {"belt_slip", {{"creep_per_Nm", 0.05 * scale / it.peak_torque_Nm()}}};
}

Effect play(double scale, const Situation& it, Draws) {
  return {"harmonic_drive_play",
          {{"twist_rad_Nm", 0.05 * scale / it.peak_torque_Nm()},
           {"play_Nm", 0.25 * it.peak_torque_Nm()}}};
}

Effect drift(double scale, const Situation& it, Draws draws) {
  return {"torque_sensor_drift",
          {{"drift_Nm_s", draws.sign() * 0.02 * scale * it.peak_torque_Nm()}}};
}

Effect payload(double scale, const Situation& it, Draws draws) {
  std::vector<double> shares;
  for (std::size_t k = 0; k < it.bench.recipes.size(); ++k)
    shares.push_back(scale * (k % 2 == 0 ? draws.uniform(0.3, 0.7) : 0.0));
  return {"payload_changes", {{"shares", shares}}};
}

Effect iron_loss(double scale, const Situation& it, Draws) {
  const double loss = 0.4 * scale * it.peak_torque_Nm() / peak_A(it) / peak_A(it);
  return {"iron_loss_with_current_squared", {{"loss_Nm_A2", loss}}};
}

Effect fading_friction(double scale, const Situation& it, Draws draws) {
  return {"friction_falling_with_load",
          {{"friction_Nm", 0.3 * scale * it.peak_torque_Nm()},
           {"load_Nm", draws.uniform(0.05, 0.2) * it.peak_torque_Nm()}}};
}

Effect hum(double scale, const Situation& it, Draws draws) {
  const bool in_torque = draws.chance(0.5);
  return {"hum",
          {{"channel", in_torque ? "output_torque_Nm" : "motor_current_A"},
           {"amplitude", 0.1 * scale * (in_torque ? it.peak_torque_Nm() : peak_A(it))},
           {"hz", draws.uniform(2, 12)}}};
}

}  // namespace

const std::vector<Outside>& outside_kinds() {
  static const std::vector<Outside> kinds = {
      {"parallel_spring",
       {.loads = {"dynamometer", "pendulum"}, .drive = "current"},
       {"output_position_rad"},
       spring},
      {"end_stop", {.loads = {"pendulum"}, .drive = "current"}, {"output_position_rad"}, stop},
      {"encoder_eccentricity", kTwoEncoders, {"output_position_rad"}, eccentricity},
      {"encoder_interpolation",
       {.loads = kSensor, .two_encoders = true, .drive = "current", .output_order = kLines},
       {"output_position_rad"},
       interpolation},
      {"current_gain_by_sign",
       kTorqueAndCurrent,
       {"motor_current_A", "output_torque_Nm"},
       gain_by_sign},
      {"current_dead_band", kTorqueAndCurrent, {"motor_current_A", "output_torque_Nm"}, dead_band},
      {"friction_growing_with_time",
       {.loads = {"dynamometer", "free"}, .drive = "current"},
       {"time_s"},
       growing_friction},
      {"belt_slip", kTwoEncoders, {"time_s", "output_position_rad"}, slip},
      {"harmonic_drive_play", kTwoEncoders, {"output_torque_Nm", "motor_current_A"}, play},
      {"torque_sensor_drift", kTorqueAndCurrent, {"time_s"}, drift},
      {"payload_changes",
       {.loads = {"free", "pendulum"}, .drive = "current"},
       {"run", "output_position_rad"},
       payload},
      {"iron_loss_with_current_squared",
       kTorqueAndCurrent,
       {"motor_current_A", "output_torque_Nm"},
       iron_loss},
      {"friction_falling_with_load",
       kTorqueAndCurrent,
       {"output_torque_Nm", "motor_current_A"},
       fading_friction},
      {"hum", kTorqueAndCurrent, {"time_s"}, hum},
  };
  return kinds;
}

}  // namespace torquewright::oracles::mujoco_bench
