// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/mujoco_bench/documents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "tests/oracles/mujoco_bench/balance.hpp"
#include "tests/oracles/mujoco_bench/plant.hpp"

namespace torquewright::oracles::mujoco_bench {
namespace {

using Json = nlohmann::ordered_json;

Json effects_json(const std::vector<Effect>& effects) {
  Json list = Json::array();
  for (const Effect& one : effects)
    list.push_back({{"effect", one.name}, {"parameters", one.parameters}});
  return list;
}

Json load_json(const Load& load) {
  Json json = {{"type", load.type}};
  if (load.type == "free" || load.type == "pendulum") json["inertia_kg_m2"] = load.inertia_kg_m2;
  if (load.type == "pendulum" || load.type == "linear_axis") json["mass_kg"] = load.mass_kg;
  if (load.type == "pendulum") json["length_m"] = load.length_m;
  return json;
}

std::string log_text(const Made& made, std::uint64_t seed) {
  const Situation& it = made.situation;
  Draws draws(seed ^ 0x6E6F697365ULL);
  std::string text = "run,time_s";
  for (const std::string& quantity : it.format.quantities) text += "," + quantity;
  text += "\n";
  for (const Record& record : made.records) {
    Channels channels = sense(it.bench.world, it.format, record);
    add_noise(channels, it.format, draws);
    const auto times = thinned(record.time_s, it.format.records_per_row);
    for (std::size_t k = 0; k < times.size(); ++k) {
      fmt::format_to(std::back_inserter(text), "{},{:.9g}", record.name, times[k]);
      for (const std::string& quantity : it.format.quantities)
        fmt::format_to(std::back_inserter(text), ",{:.9g}", channels.at(quantity)[k]);
      text += "\n";
    }
  }
  return text;
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace

Json actuator_document(const Situation& it) {
  const Motor& motor = it.stated.motor;
  Json json = {
      {"kind", "actuator"},
      {"version", 1},
      {"name", "foreign bench"},
      {"motor",
       {{"torque_constant_Nm_A", motor.torque_constant_Nm_A},
        {"torque_constant_convention", "dc"},
        {"resistance_ohm", motor.resistance_ohm},
        {"resistance_convention", "dc"},
        {"pole_pairs", motor.pole_pairs},
        {"rotor_inertia_kg_m2", motor.rotor_inertia_kg_m2},
        {"winding_temperature_K", motor.reference_temperature_K}}},
      {"drive", {{"bus_voltage_V", motor.bus_voltage_V}, {"peak_current_A", motor.peak_current_A}}},
      {"gearbox",
       {{"ratio", motor.ratio},
        {"forward_efficiency", motor.forward_efficiency},
        {"backward_efficiency", motor.backward_efficiency}}}};
  if (!it.declared.empty()) json["effects"] = effects_json(it.declared);
  return json;
}

Json rig_document(const Situation& it) {
  Json columns = {{"run", "run"}, {"time_s", "time_s"}};
  for (const std::string& quantity : it.format.quantities) columns[quantity] = quantity;
  Json json = {{"kind", "rig"},
               {"version", 1},
               {"name", "foreign bench"},
               {"columns", columns},
               {"load", load_json(it.stated.load)}};
  if (!it.holdout_runs.empty()) json["holdout_runs"] = it.holdout_runs;
  if (!it.uncertain.empty()) json["uncertain"] = it.uncertain;
  return json;
}

Json truth_document(const Situation& it, std::uint64_t seed) {
  const bool is_outside = it.kind == "outside";
  Json json = {{"class", it.kind},
               {"seed", seed},
               {"generator", "mujoco"},
               {"rig", it.stated.load.type},
               {"drive", it.bench.voltage_driven ? "voltage" : "current"},
               {"effects", is_outside ? Json::array() : effects_json(it.missing)},
               {"size_floors", it.size_floors},
               {"accept", it.accept},
               {"noise_rms", {{"unit", "Nm"}, {"value", it.noise_Nm}, {"band_hz", kBand_hz}}}};
  if (is_outside)
    json["outside"] = {{"kind", it.missing.front().name},
                       {"coordinates", it.outside_coordinates},
                       {"parameters", it.missing.front().parameters}};
  const bool plays = std::any_of(it.missing.begin(), it.missing.end(),
                                 [](const auto& each) { return each.name == "backlash"; });
  if (plays) json["flank_stiffness_Nm_rad"] = flank_stiffness_Nm_rad(it.bench.world);
  json["note"] = it.note;
  return json;
}

void write_all(const Made& made, std::uint64_t seed, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  write(folder / "log.csv", log_text(made, seed));
  write(folder / "rig.json", rig_document(made.situation).dump(1) + "\n");
  write(folder / "actuator.json", actuator_document(made.situation).dump(1) + "\n");
  write(folder / "truth.json", truth_document(made.situation, seed).dump(1) + "\n");
}

}  // namespace torquewright::oracles::mujoco_bench
