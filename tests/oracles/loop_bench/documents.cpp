// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/loop_bench/documents.hpp"

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

namespace torquewright::oracles::loop {
namespace {

using Json = nlohmann::ordered_json;

Json effects_json(const std::vector<Law>& laws) {
  Json list = Json::array();
  for (const Law& law : laws) {
    Json parameters = Json::object();
    for (const auto& [key, value] : law.values) parameters[key] = value;
    if (law.values.contains("order")) parameters = {{"harmonics", {parameters}}};
    list.push_back({{"effect", law.name}, {"parameters", parameters}});
  }
  return list;
}

Json actuator_json(const Drive& drive, const std::string& name) {
  return {
      {"kind", "actuator"},
      {"version", 1},
      {"name", name},
      {"motor",
       {{"torque_constant_Nm_A", drive.torque_constant_Nm_A},
        {"torque_constant_convention", "dc"},
        {"resistance_ohm", drive.resistance_ohm},
        {"resistance_convention", "dc"},
        {"rotor_inertia_kg_m2", drive.rotor_inertia_kg_m2}}},
      {"drive", {{"bus_voltage_V", drive.bus_V}, {"peak_current_A", drive.peak_current_A}}},
      {"gearbox", {{"ratio", drive.ratio}, {"forward_efficiency", 1}, {"backward_efficiency", 1}}},
      {"effects", effects_json(drive.stated)}};
}

Json load_json(const Situation& it) {
  const Link& first = it.rig.links.front();
  if (it.rig.shape == "flywheel") return {{"type", "free"}, {"inertia_kg_m2", first.inertia_kg_m2}};
  if (it.rig.shape == "pendulum")
    return {{"type", "pendulum"},
            {"mass_kg", first.mass_kg},
            {"length_m", first.length_m},
            {"inertia_kg_m2", first.inertia_kg_m2}};
  Json links = Json::array();
  for (std::size_t j = 0; j < it.rig.links.size(); ++j) {
    const Link& link = it.rig.links[j];
    links.push_back({{"joint", it.sensing.joint_names[j]},
                     {"mass_kg", link.mass_kg},
                     {"length_m", link.length_m},
                     {"center_of_mass_m", link.center_m},
                     {"inertia_kg_m2", link.inertia_kg_m2}});
  }
  return {{"type", "serial_arm"}, {"links", links}};
}

std::vector<std::string> quantities_of(const Sensing& sensing) {
  std::vector<std::string> names{"output_position_rad"};
  if (sensing.logs_velocity) names.push_back("output_velocity_rad_s");
  if (!sensing.logs_voltage) names.push_back("motor_current_A");
  if (sensing.logs_voltage) names.insert(names.end(), {"duty", "bus_voltage_V"});
  return names;
}

double value_of(const Sample& sample, const std::string& quantity) {
  if (quantity == "output_position_rad") return sample.position_rad;
  if (quantity == "output_velocity_rad_s") return sample.velocity_rad_s;
  if (quantity == "motor_current_A") return sample.current_A;
  return quantity == "duty" ? sample.duty : sample.bus_V;
}

Json rig_json(const Situation& it) {
  Json columns = {{"run", "run"}, {"t", "time_s"}};
  for (const std::string& quantity : quantities_of(it.sensing)) {
    if (it.sensing.joint_names.empty()) columns[quantity] = quantity;
    for (const std::string& joint : it.sensing.joint_names)
      columns[joint + "_" + quantity] = {{"quantity", quantity}, {"joint", joint}};
  }
  return {{"kind", "rig"},
          {"version", 1},
          {"name", it.rig.shape},
          {"columns", columns},
          {"load", load_json(it)}};
}

std::string log_text(const Made& made) {
  const Sensing& sensing = made.situation.sensing;
  const auto quantities = quantities_of(sensing);
  std::string text = "run,t";
  for (std::size_t j = 0; j < made.situation.rig.joints(); ++j)
    for (const std::string& quantity : quantities)
      text += "," + (sensing.joint_names.empty() ? "" : sensing.joint_names[j] + "_") + quantity;
  text += "\n";
  for (std::size_t run = 0; run < made.records.size(); ++run) {
    for (const Row& row : made.records[run]) {
      char number[64];
      std::snprintf(number, sizeof number, "run_%zu,%.6f", run, row.time_s);
      text += number;
      for (const Sample& sample : row.joints) {
        for (const std::string& quantity : quantities) {
          std::snprintf(number, sizeof number, ",%.9g", value_of(sample, quantity));
          text += number;
        }
      }
      text += "\n";
    }
  }
  return text;
}

/// What a filter of the current and differences of positions are rightly called, and how late they
/// are at most.
Json tolerated_json(const Situation& it) {
  const double filter_s = 0.5 / std::numbers::pi / it.sensing.current_filter_Hz;
  Json names = {{"channel_delay", 1.5 * filter_s + 0.6 / it.sensing.rate_Hz},
                {"velocity_mismatch", nullptr}};
  for (const std::string& name : it.hidden)
    if (name == "asymmetric_friction")
      names["coulomb_friction"] = names["viscous_friction"] = nullptr;
  return names;
}

Json truth_json(const Made& made) {
  const Situation& it = made.situation;
  std::vector<Law> hidden = it.rig.drives[it.joint].hidden;
  if (it.sensing.current_offset_A != 0.0)
    hidden.push_back({"current_offset", {{"value", it.sensing.current_offset_A}}});
  if (it.sensing.current_delay_s != 0.0)
    hidden.push_back({"channel_delay", {{"delay_s", it.sensing.current_delay_s}}});
  Json truth = {{"class", it.kind},
                {"seed", it.seed},
                {"generator", "loop"},
                {"rig", it.rig.shape},
                {"drive", it.sensing.logs_voltage ? "duty" : "current"},
                {"effects", it.kind == "outside" ? Json::array() : effects_json(hidden)},
                {"floors", made.floors},
                {"size_floors", made.size_floors},
                {"recoverable", made.is_recoverable},
                {"accept", it.accept},
                {"tolerated", tolerated_json(it)},
                {"rate_Hz", it.sensing.rate_Hz}};
  if (it.kind == "outside")
    truth["outside"] = {{"kind", it.hidden.front()}, {"coordinates", it.coordinates}};
  return truth;
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace

void write_all(const Made& made, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const Situation& it = made.situation;
  for (const char* old : {"actuator.json", "actuator_hip.json", "actuator_knee.json",
                          "actuator_shoulder.json", "actuator_elbow.json"})
    std::filesystem::remove(folder / old);
  for (std::size_t j = 0; j < it.rig.joints(); ++j) {
    const std::string joint = it.sensing.joint_names.empty() ? "" : it.sensing.joint_names[j];
    const std::string name = joint.empty() ? "actuator" : "actuator_" + joint;
    write(folder / (name + ".json"), actuator_json(it.rig.drives[j], name).dump(1) + "\n");
  }
  write(folder / "log.csv", log_text(made));
  write(folder / "rig.json", rig_json(it).dump(1) + "\n");
  write(folder / "truth.json", truth_json(made).dump(1) + "\n");
}

}  // namespace torquewright::oracles::loop
