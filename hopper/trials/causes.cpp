// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/causes.hpp"

#include <algorithm>
#include <array>

namespace torquewright::hopper {
namespace {

bool has_width(const Range& range) { return range.least < range.greatest; }
bool has_width(const std::optional<Range>& range) { return range && has_width(*range); }
bool has_width(const NamedRange& range) { return has_width(range.range); }
bool has_width(const ShiftRange& range) { return has_width(range.of_bodies); }

template <typename One>
bool has_width(const std::vector<One>& ranges) {
  return std::any_of(ranges.begin(), ranges.end(), [](const One& one) { return has_width(one); });
}

/// A key of the document: whether it varies, and how it is taken over alone.
struct Key {
  const char* name;
  bool (*varies)(const Randomisation& of);
  void (*take)(const Randomisation& from, Randomisation& to);
};

template <auto kMember>
constexpr Key range(const char* name) {
  return {name, [](const Randomisation& of) { return has_width(of.*kMember); },
          [](const Randomisation& from, Randomisation& to) { to.*kMember = from.*kMember; }};
}

template <auto kMember>
constexpr Key noise(const char* name) {
  return {name, [](const Randomisation& of) { return of.noise.*kMember > 0.0; },
          [](const Randomisation& from, Randomisation& to) {
            to.noise.distribution = from.noise.distribution;
            to.noise.*kMember = from.noise.*kMember;
          }};
}

constexpr std::array kKeys{
    range<&Randomisation::total_mass_factor>("total_mass_factor"),
    range<&Randomisation::body_mass_factor>("body_mass_factor"),
    range<&Randomisation::body_inertia_factor>("body_inertia_factor"),
    range<&Randomisation::center_of_mass_shift_m>("center_of_mass_shift_m"),
    range<&Randomisation::controller_gain_factor>("controller_gain_factor"),
    range<&Randomisation::motor_strength_factor>("motor_strength_factor"),
    range<&Randomisation::further_friction_Nm>("further_friction_Nm"),
    range<&Randomisation::friction_coefficient>("friction_coefficient"),
    range<&Randomisation::restitution>("restitution"),
    range<&Randomisation::ground_height_m>("ground_height_m"),
    range<&Randomisation::latency_s>("latency_s"),
    range<&Randomisation::state_of_charge>("state_of_charge"),
    range<&Randomisation::bus_voltage_factor>("bus_voltage_factor"),
    range<&Randomisation::winding_temperature_K>("winding_temperature_K"),
    range<&Randomisation::initial_joint_position_rad>("initial_joint_position_rad"),
    range<&Randomisation::initial_joint_velocity_rad_s>("initial_joint_velocity_rad_s"),
    noise<&SensorNoiseLevels::gravity_direction>("sensor_noise/gravity_direction"),
    noise<&SensorNoiseLevels::base_rate_rad_s>("sensor_noise/base_rate_rad_s"),
    noise<&SensorNoiseLevels::base_position_m>("sensor_noise/base_position_m"),
    noise<&SensorNoiseLevels::base_velocity_m_s>("sensor_noise/base_velocity_m_s"),
    noise<&SensorNoiseLevels::joint_position_rad>("sensor_noise/joint_position_rad"),
    noise<&SensorNoiseLevels::joint_velocity_rad_s>("sensor_noise/joint_velocity_rad_s")};

}  // namespace

bool has_noise(const SensorNoiseLevels& noise) {
  Randomisation quiet;
  quiet.noise = noise;
  return !causes_of(quiet).empty();
}

std::vector<Cause> causes_of(const Randomisation& randomisation) {
  std::vector<Cause> causes;
  for (const Key& key : kKeys) {
    if (!key.varies(randomisation)) continue;
    Cause& cause = causes.emplace_back();
    cause.name = key.name;
    cause.alone.file = randomisation.file;
    key.take(randomisation, cause.alone);
  }
  return causes;
}

}  // namespace torquewright::hopper
