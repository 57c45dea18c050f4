// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/mujoco_bench/sensing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace torquewright::oracles::mujoco_bench {
namespace {

using Numbers = std::vector<double>;

Numbers late(const Numbers& numbers, double delay_s) {
  Numbers moved(numbers.size());
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const double at = std::max(0.0, static_cast<double>(k) - delay_s / kRecord_s);
    const auto below = static_cast<std::size_t>(at);
    const double share = at - static_cast<double>(below);
    const std::size_t above = std::min(below + 1, numbers.size() - 1);
    moved[k] = numbers[below] + share * (numbers[above] - numbers[below]);
  }
  return moved;
}

Numbers sensed_position(const Sensors& sensors, Numbers position) {
  for (double& q : position)
    q += sensors.eccentricity_rad * std::sin(q + sensors.eccentricity_phase_rad) +
         sensors.interpolation_rad * std::sin(sensors.interpolation_order * q);
  return position;
}

Numbers sensed_current(const Sensors& sensors, Numbers current) {
  for (double& i : current) {
    const double beyond = std::max(0.0, std::abs(i) - sensors.dead_band_A);
    const double gain = 1 + std::copysign(sensors.gain_by_sign, i);
    i = std::copysign(beyond, i) * gain + sensors.current_offset_A;
  }
  return current;
}

/// A belt creeps with the force it carries; a flexspline's play trails the torque (both twist the
/// motor's side, in output angle).
Numbers sensed_rotor(const World& world, const Record& record) {
  const Sensors& sensors = world.sensors;
  Numbers rotor = record.rotor_rad;
  double crept_rad = 0, play_Nm = 0;
  for (std::size_t k = 0; k < rotor.size(); ++k) {
    crept_rad +=
        sensors.creep_per_Nm * record.torque_Nm[k] * std::abs(record.speed_rad_s[k]) * kRecord_s;
    play_Nm = std::clamp(play_Nm, record.torque_Nm[k] - sensors.play_Nm,
                         record.torque_Nm[k] + sensors.play_Nm);
    rotor[k] += world.motor.ratio * (crept_rad + sensors.play_rad_Nm * play_Nm);
  }
  return rotor;
}

/// Drift goes on from run to run, a minute apart.
Numbers sensed_torque(const Sensors& sensors, const Record& record) {
  Numbers torque = record.torque_Nm;
  for (std::size_t k = 0; k < torque.size(); ++k)
    torque[k] += sensors.torque_offset_Nm + sensors.torque_drift_Nm_s * record.time_s[k];
  return torque;
}

Numbers sensed_velocity(const Sensors& sensors, const Record& record) {
  Numbers velocity = late(record.speed_rad_s, sensors.velocity_delay_s);
  for (double& w : velocity) w *= sensors.velocity_scale;
  return velocity;
}

Numbers scaled(Numbers numbers, double factor) {
  for (double& x : numbers) x *= factor;
  return numbers;
}

Numbers winding_voltage(const Record& record) {
  Numbers voltage(record.duty.size());
  for (std::size_t k = 0; k < voltage.size(); ++k) voltage[k] = record.duty[k] * record.bus_V[k];
  return voltage;
}

Numbers sensed(const World& world, const Record& record, const std::string& quantity) {
  const Sensors& sensors = world.sensors;
  if (quantity == "output_position_rad" || quantity == "linear_position_m")
    return sensed_position(sensors, record.position_rad);
  if (quantity == "output_velocity_rad_s" || quantity == "linear_velocity_m_s")
    return sensed_velocity(sensors, record);
  if (quantity == "motor_position_rad") return sensed_rotor(world, record);
  if (quantity == "motor_velocity_rad_s")
    return scaled(sensed_velocity(sensors, record), world.motor.ratio);
  if (quantity == "motor_current_A") return sensed_current(sensors, record.current_A);
  if (quantity == "output_torque_Nm") return sensed_torque(sensors, record);
  if (quantity == "winding_temperature_K") return record.temperature_K;
  if (quantity == "duty") return record.duty;
  if (quantity == "bus_voltage_V") return record.bus_V;
  return winding_voltage(record);
}

void add_hum(Numbers& numbers, const Sensors& sensors, const Record& record) {
  for (std::size_t k = 0; k < numbers.size(); ++k)
    numbers[k] +=
        sensors.hum_amplitude * std::sin(2 * std::numbers::pi * sensors.hum_hz * record.time_s[k]);
}

}  // namespace

bool LogFormat::has(const std::string& quantity) const {
  return std::find(quantities.begin(), quantities.end(), quantity) != quantities.end();
}

Numbers thinned(const Numbers& numbers, int stride) {
  Numbers kept;
  for (std::size_t k = 0; k < numbers.size(); k += static_cast<std::size_t>(stride))
    kept.push_back(numbers[k]);
  return kept;
}

Channels sense(const World& world, const LogFormat& format, const Record& record) {
  Channels channels;
  for (const std::string& quantity : format.quantities) {
    Numbers numbers = sensed(world, record, quantity);
    if (const auto delay = world.sensors.delay_s.find(quantity);
        delay != world.sensors.delay_s.end())
      numbers = late(numbers, delay->second);
    if (quantity == world.sensors.hum_channel) add_hum(numbers, world.sensors, record);
    channels[quantity] = thinned(numbers, format.records_per_row);
  }
  return channels;
}

void add_noise(Channels& channels, const LogFormat& format, Draws& draws) {
  for (const std::string& quantity : format.quantities) {
    const Grain grain = format.grains.at(quantity);
    for (double& x : channels.at(quantity)) {
      x += grain.noise * draws.normal();
      if (grain.quantum > 0) x = std::round(x / grain.quantum) * grain.quantum;
    }
  }
}

}  // namespace torquewright::oracles::mujoco_bench
