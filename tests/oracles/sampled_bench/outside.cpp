// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/sampled_bench/outside.hpp"

#include <cmath>

namespace torquewright::oracles::sampled {
namespace {

double total_s(const Situation& situation) {
  double sum = 0.0;
  for (const RunPlan& run : situation.runs) sum += run.duration_s;
  return sum;
}

void set_machine(Situation& situation, const std::string& name, double strength, Draw& draw) {
  Oddities& odd = situation.odd;
  const Plant& plant = situation.plant;
  const double torque = plant.used_torque_Nm;
  if (name == "parallel_spring") {
    odd.spring_Nm_rad = 0.4 * strength * torque / plant.used_angle_rad;
    odd.spring_rest_rad = draw.uniform(-0.3, 0.3) * plant.used_angle_rad;
  } else if (name == "end_stop") {
    odd.stop_Nm_rad = 3.0 * strength * torque / plant.used_angle_rad;
    odd.stop_rad = draw.uniform(0.2, 0.5) * plant.used_angle_rad;
  } else if (name == "friction_grows_with_time") {
    odd.friction_growth_1_s = 4.0 * strength / total_s(situation);
  } else if (name == "friction_falls_with_load") {
    odd.lubrication_Nm = 0.3 * torque / strength;
  } else if (name == "iron_loss") {
    odd.iron_loss_Nm_A2 = 0.5 * strength * plant.Nm_per_A() * plant.Nm_per_A() / torque;
  } else if (name == "harmonic_drive_hysteresis") {
    odd.hysteresis_Nm = 0.4 * strength * torque;
    odd.hysteresis_rad = draw.uniform(0.02, 0.1) * plant.used_angle_rad;
  } else if (name == "belt_slip") {
    odd.slip_per_Nm = 0.02 * strength / torque;
  } else if (name == "payload_changes") {
    for (std::size_t k = 0; k < situation.runs.size(); ++k) {
      situation.runs[k].mass_factor =
          1.0 + (k % 3 == 1 ? 0.6 : (k % 3 == 2 ? -0.3 : 0.0)) * strength;
    }
  }
}

void set_sensor(Situation& situation, const std::string& name, double strength, Draw& draw) {
  SensorOddities& odd = situation.sensor_odd;
  const Plant& plant = situation.plant;
  const double current_A = plant.used_torque_Nm / plant.Nm_per_A();
  if (name == "encoder_eccentricity") {
    odd.eccentricity_rad = 0.05 * strength;
    odd.eccentricity_phase_rad = draw.uniform(-3.1, 3.1);
  } else if (name == "encoder_interpolation") {
    odd.interpolation_lines = draw.one_of(std::vector<double>{8, 16, 32});
    odd.interpolation_rad = 0.5 * strength / odd.interpolation_lines;
  } else if (name == "current_gain_by_sign") {
    odd.negative_gain = 1.0 + draw.sign() * 0.4 * strength;
  } else if (name == "current_dead_band") {
    odd.dead_band_A = 0.4 * strength * current_A;
  } else if (name == "torque_sensor_drift") {
    odd.torque_drift_1_s = 0.6 * strength * plant.used_torque_Nm / total_s(situation);
  } else if (name == "hum") {
    odd.hum_hz = draw.uniform(1.7, 6.5);
    odd.hum_channel = draw.chance(0.5) ? kTorque : kCurrent;
    odd.hum = 0.5 * strength * (odd.hum_channel == kTorque ? plant.used_torque_Nm : current_A);
  }
}

}  // namespace

const std::vector<OutsideKind>& outside_kinds() {
  using enum LoadKind;
  static const std::vector<OutsideKind> kKinds{
      {"parallel_spring", kPendulum, false, false, {"output_position_rad"}},
      {"end_stop", kPendulum, false, false, {"output_position_rad"}},
      {"encoder_eccentricity", kImposedSpeed, true, false, {"output_position_rad"}},
      {"encoder_interpolation", kImposedSpeed, true, false, {"output_position_rad"}},
      {"current_gain_by_sign", kImposedSpeed, false, false, {"motor_current_A"}},
      {"current_dead_band", kImposedSpeed, false, false, {"motor_current_A"}},
      {"friction_grows_with_time", kImposedSpeed, false, true, {"time_s", "run"}},
      {"belt_slip", kImposedSpeed, true, false, {"output_torque_Nm", "time_s"}},
      {"harmonic_drive_hysteresis",
       kImposedSpeed,
       false,
       false,
       {"output_position_rad", "output_velocity_rad_s"}},
      {"torque_sensor_drift", kImposedSpeed, false, false, {"time_s", "run"}},
      {"payload_changes", kPendulum, false, false, {"run", "output_position_rad"}},
      {"iron_loss", kImposedSpeed, false, false, {"motor_current_A"}},
      {"friction_falls_with_load", kImposedSpeed, false, true, {"output_torque_Nm"}},
      {"hum", kImposedSpeed, false, false, {"time_s"}}};
  return kKinds;
}

void set_outside(Situation& situation, const OutsideKind& kind, double strength,
                 std::uint64_t seed) {
  Draw draw(seed);
  situation.odd = {};
  situation.sensor_odd = {};
  situation.odd_kind = kind.name;
  situation.odd_coordinates = kind.coordinates;
  set_machine(situation, kind.name, strength, draw);
  set_sensor(situation, kind.name, strength, draw);
}

Equation equation_of_outside(const std::string& kind) {
  const bool between =
      kind == "encoder_eccentricity" || kind == "encoder_interpolation" || kind == "belt_slip";
  return between ? Equation::kTwist : Equation::kTorque;
}

}  // namespace torquewright::oracles::sampled
