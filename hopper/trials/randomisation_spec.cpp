// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/randomisation_spec.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/text/wording.hpp"

namespace torquewright::hopper {
namespace {

using nlohmann::json;

class RandomisationReader {
 public:
  explicit RandomisationReader(io::Document document) : document_{std::move(document)} {}

  ReadRandomisation read() {
    Randomisation read;
    read.file = document_.file;
    read.total_mass_factor = range("total_mass_factor");
    read.body_mass_factor = ranges("body_mass_factor", "bodies");
    read.body_inertia_factor = ranges("body_inertia_factor", "bodies");
    read.center_of_mass_shift_m = shifts();
    read.controller_gain_factor = ranges("controller_gain_factor", "drives");
    read.motor_strength_factor = ranges("motor_strength_factor", "drives");
    read.further_friction_Nm = ranges("further_friction_Nm", "drives");
    read.friction_coefficient = range("friction_coefficient");
    read.restitution = range("restitution");
    read.ground_height_m = range("ground_height_m");
    read.latency_s = range("latency_s");
    read.state_of_charge = range("state_of_charge");
    read.bus_voltage_factor = range("bus_voltage_factor");
    read.winding_temperature_K = range("winding_temperature_K");
    read.initial_joint_position_rad = ranges("initial_joint_position_rad", "joints");
    read.initial_joint_velocity_rad_s = ranges("initial_joint_velocity_rad_s", "joints");
    read.noise = noise();
    read.assumed = root().value("assumed", read.assumed);
    if (!faults_.empty()) throw io::SpecError(std::move(faults_));
    return {std::move(read), std::move(document_)};
  }

 private:
  const json& root() const { return document_.root; }

  Range ends_of(const json& keys, const std::string& path) {
    const Range range{keys["least"], keys["greatest"]};
    if (range.least > range.greatest) {
      faults_.push_back(
          {document_.file, path,
           fmt::format("least, {}, is above greatest, {}", io::as_written(keys["least"]),
                       io::as_written(keys["greatest"]))});
    }
    return range;
  }

  std::optional<Range> range(const std::string& key) {
    if (!root().contains(key)) return std::nullopt;
    return ends_of(root()[key], "/" + key);
  }

  NamedRange named(const json& keys, const std::string& path, const char* things) {
    return {ends_of(keys, path), keys.value(things, std::vector<std::string>{}), path};
  }

  std::vector<NamedRange> ranges(const std::string& key, const char* things) {
    std::vector<NamedRange> list;
    for (const json& keys : root().value(key, json::array())) {
      list.push_back(named(keys, fmt::format("/{}/{}", key, list.size()), things));
    }
    return list;
  }

  std::vector<ShiftRange> shifts() {
    std::vector<ShiftRange> list;
    for (const json& keys : root().value("center_of_mass_shift_m", json::array())) {
      ShiftRange shift;
      shift.of_bodies =
          named(keys, fmt::format("/center_of_mass_shift_m/{}", list.size()), "bodies");
      if (keys.contains("along")) {
        shift.along.fill(false);
        for (const std::string axis : keys["along"]) {
          shift.along[static_cast<std::size_t>(axis.front() - 'x')] = true;
        }
      }
      list.push_back(std::move(shift));
    }
    return list;
  }

  SensorNoiseLevels noise() const {
    SensorNoiseLevels levels;
    if (!root().contains("sensor_noise")) return levels;
    const json& keys = root()["sensor_noise"];
    levels.distribution =
        keys["distribution"] == "normal" ? NoiseDistribution::kNormal : NoiseDistribution::kUniform;
    levels.gravity_direction = keys.value("gravity_direction", 0.0);
    levels.base_rate_rad_s = keys.value("base_rate_rad_s", 0.0);
    levels.base_position_m = keys.value("base_position_m", 0.0);
    levels.base_velocity_m_s = keys.value("base_velocity_m_s", 0.0);
    levels.joint_position_rad = keys.value("joint_position_rad", 0.0);
    levels.joint_velocity_rad_s = keys.value("joint_velocity_rad_s", 0.0);
    return levels;
  }

  io::Document document_;
  std::vector<io::Fault> faults_;
};

}  // namespace

ReadRandomisation read_randomisation(const std::filesystem::path& file) {
  return randomisation_of(io::read_document(file, "randomisation"));
}

ReadRandomisation randomisation_of(io::Document document) {
  return RandomisationReader(std::move(document)).read();
}

}  // namespace torquewright::hopper
