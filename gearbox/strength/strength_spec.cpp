// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/strength_spec.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gearbox/topologies/topology.hpp"
#include "io/text/one_line.hpp"

namespace torquewright::gearbox {
namespace {

using nlohmann::json;

[[noreturn]] void refuse_strength(const io::Document& document, const std::string& path,
                                  std::string message) {
  throw io::SpecError({{document.file, document.path + path, std::move(message)}});
}

/// Their names: "3k".
std::string two_layer_trains() {
  std::vector<std::string_view> names;
  for (const TrainParts& each : all_train_parts()) {
    if (each.layer_count() == 2) names.push_back(each.name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Teeth, shifts, planets and module from the keys of a gearbox at `path` of a document.
GearTrain train_of(const json& keys, const std::string& topology_name, const io::Document& document,
                   const std::string& path) {
  GearTrain train;
  train.topology = topology_name;
  train.planet_count = keys["planet_count"];
  train.module_mm = keys["module_mm"];
  const Topology& topology = *find_topology(topology_name);
  if (keys.contains("layer_2_module_mm")) {
    if (topology.layer_count() < 2) {
      refuse_strength(
          document, path + "/layer_2_module_mm",
          fmt::format("is for {} trains; \"{}\" has one layer", two_layer_trains(), topology_name));
    }
    train.layer_2_module_mm = keys["layer_2_module_mm"].get<double>();
  }
  const json shifts = keys.value("profile_shift", json::object());
  for (const std::string_view gear : topology.gears) {
    const std::string name(gear);
    if (!keys["teeth"].contains(name)) {
      refuse_strength(document, path + "/teeth/" + name,
                      fmt::format("missing; the topology \"{}\" has it", topology_name));
    }
    train.teeth.push_back(keys["teeth"][name]);
    train.shifts.push_back(shifts.value(name, 0.0));
  }
  return train;
}

GearTrain train_from_file(const io::Document& gearbox) {
  const json& root = gearbox.root;
  if (root["kind"] == "gearbox") return train_of(root, root["topology"], gearbox, "");
  if (root["designs"].empty()) {
    refuse_strength(gearbox, "/designs", "holds no design: there is no gearbox to take");
  }
  if (root["status"] == "infeasible") {
    refuse_strength(gearbox, "/status",
                    "infeasible: its design violates the problem's constraints");
  }
  return train_of(root["designs"][0], root["problem"]["topology"], gearbox, "/designs/0");
}

GearTrain read_train(ReadStrength& read) {
  const io::Document document = read.documents.front();
  const json& keys = document.root["gearbox"];
  if (!keys.contains("file")) return train_of(keys, keys["topology"], document, "/gearbox");
  const std::filesystem::path file =
      std::filesystem::path(document.file).parent_path() / keys["file"].get<std::string>();
  read.documents.push_back(io::read_document(file, {"gearbox", "gearbox_result"}));
  return train_from_file(read.documents.back());
}

void read_face_widths(const io::Document& document, GearTrain& train) {
  const json& widths = document.root["face_width_mm"];
  train.face_width_mm = {widths["layer_1"].get<double>()};
  const bool has_second = train_parts(train.topology).layer_count() == 2;
  if (widths.contains("layer_2") != has_second) {
    refuse_strength(document, "/face_width_mm/layer_2",
                    has_second ? fmt::format("missing; a {} train has two layers", train.topology)
                               : fmt::format("is for {} trains; a {} stage has one layer",
                                             two_layer_trains(), train.topology));
  }
  if (has_second) train.face_width_mm.push_back(widths["layer_2"]);
}

GearMaterial read_material(const io::Document& document, const std::string& path,
                           const json& keys) {
  GearMaterial material;
  const std::string treatment = keys["treatment"];
  material.treatment = treatment == "case_hardened"      ? Treatment::kCaseHardened
                       : treatment == "through_hardened" ? Treatment::kThroughHardened
                                                         : Treatment::kNitrided;
  material.young_MPa = keys["young_MPa"];
  material.poisson = keys["poisson"];
  material.bending_endurance_MPa = keys["bending_endurance_MPa"];
  material.contact_endurance_MPa = keys["contact_endurance_MPa"];
  if (keys.contains("yield_MPa")) material.yield_MPa = keys["yield_MPa"].get<double>();
  if (material.treatment == Treatment::kThroughHardened && !material.yield_MPa) {
    refuse_strength(document, path + "/yield_MPa",
                    "missing; the static strength of through-hardened teeth depends on it");
  }
  return material;
}

/// The gears of a topology only: the schema knows those of all.
void check_gears(const io::Document& document, const std::string& path, const json& by_gear,
                 const std::string& topology) {
  const auto& gears = find_topology(topology)->gears;
  for (const auto& entry : by_gear.items()) {
    if (std::find(gears.begin(), gears.end(), entry.key()) != gears.end()) continue;
    refuse_strength(document, path + "/" + entry.key(),
                    fmt::format("the topology \"{}\" has no such gear", topology));
  }
}

void read_own_materials(const io::Document& document, StrengthCase& strength) {
  const json keys = document.root.value("own_material", json::object());
  check_gears(document, "/own_material", keys, strength.train.topology);
  for (const auto& own : keys.items()) {
    strength.own_material[own.key()] =
        read_material(document, "/own_material/" + own.key(), own.value());
  }
}

void read_rims(const io::Document& document, StrengthCase& strength) {
  const json keys = document.root.value("rim_mm", json::object());
  check_gears(document, "/rim_mm", keys, strength.train.topology);
  for (const auto& rim : keys.items()) strength.rim_mm[rim.key()] = rim.value().get<double>();
}

/// Of a train without objections.
void check_rims(const io::Document& document, const StrengthCase& strength) {
  for (const LoadedMesh& mesh : loaded_train(strength.train).meshes) {
    for (const std::size_t which : {0U, 1U}) {
      if (rim_factor_of(strength, mesh, which)) continue;
      refuse_strength(document, fmt::format("/rim_mm/{}", mesh.gears[which]),
                      "too thin: there is a factor for more than half a tooth's height (rings: "
                      "1.75 modules) behind the root");
    }
  }
}

/// The document's own keys, else those of the result's problem; says where they differ.
Cutters read_cutters(const json& root, ReadStrength& read) {
  json keys = json::object();
  if (read.documents.size() > 1) {
    const json problem = read.documents.back().root.value("problem", json::object());
    keys = problem.value("cutter", json::object());
  }
  const json stated = root.value("cutter", json::object());
  for (const auto& [key, value] : stated.items()) {
    if (keys.contains(key) && keys[key] != value) {
      read.statements.push_back(fmt::format(
          "The cutter differs from that of the result's problem: {} is {} here and {} there.", key,
          value.dump(), keys[key].dump()));
    }
    keys[key] = value;
  }
  Cutters cutters;
  if (keys.contains("hob_tip_radius")) {
    cutters.hob_tip_radius = keys["hob_tip_radius"].get<double>();
  }
  if (keys.contains("hob_addendum")) cutters.hob_addendum = keys["hob_addendum"].get<double>();
  if (keys.contains("shaper_addendum")) {
    cutters.shaper_addendum = keys["shaper_addendum"].get<double>();
  }
  if (keys.contains("shaper_tip_radius")) {
    cutters.shaper_tip_radius = keys["shaper_tip_radius"].get<double>();
  }
  if (keys.contains("shaper_teeth")) {
    cutters.shaper_teeth = keys["shaper_teeth"].get<std::int64_t>();
  }
  return cutters;
}

LoadFactors read_factors(const json& keys) {
  return {keys["application"],    keys["dynamic"],         keys["load_sharing"],
          keys["face_load_root"], keys["face_load_flank"], keys["alternating_bending"]};
}

}  // namespace

ReadStrength read_strength(const std::filesystem::path& file) {
  return strength_of(io::read_document(file, "gear_strength"));
}

ReadStrength strength_of(io::Document document) {
  const json root = document.root;
  ReadStrength read;
  read.name = root.value("name", io::stem_in_text(document.file));
  read.assumed = root.value("assumed", read.assumed);
  read.documents.push_back(std::move(document));
  StrengthCase& strength = read.strength;
  strength.train = read_train(read);
  read_face_widths(read.documents.front(), strength.train);
  strength.train.cutters = read_cutters(root, read);
  strength.material = read_material(read.documents.front(), "/material", root["material"]);
  read_own_materials(read.documents.front(), strength);
  read_rims(read.documents.front(), strength);
  strength.factors = read_factors(root["factors"]);
  strength.cycles = root["cycles"];
  strength.demanded_root_safety = root["safety_factor"]["root"];
  strength.demanded_flank_safety = root["safety_factor"]["flank"];
  if (root.contains("rotor_inner_diameter_mm")) {
    read.ring_space_mm = root["rotor_inner_diameter_mm"].get<double>();
  }
  const std::vector<std::string> found = objections(strength.train);
  if (!found.empty()) {
    refuse_strength(read.documents.back(), read.documents.size() == 1 ? "/gearbox" : "",
                    found.front());
  }
  check_rims(read.documents.front(), strength);
  return read;
}

}  // namespace torquewright::gearbox
