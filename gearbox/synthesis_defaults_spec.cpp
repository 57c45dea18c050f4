// SPDX-License-Identifier: Apache-2.0
#include "gearbox/synthesis_defaults_spec.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "gearbox/any_topology.hpp"
#include "gearbox/train_parts.hpp"
#include "io/documents/json_reader.hpp"
#include "io/files/file_bytes.hpp"
#include "io/files/sha256.hpp"

namespace torquewright::gearbox {
namespace {

using nlohmann::json;

using Defaults = std::vector<std::pair<std::string, json>>;

/// 12 of every gear that has a minimum. A topology that the schema refuses is not spoken of here.
json least_teeth(const json& topology) {
  std::vector<std::string> gears;
  if (topology.is_string()) gears = gears_with_minima(topology.get<std::string>());
  if (gears.empty()) gears = gears_with_minima(all_train_parts().front().name);
  json teeth = json::object();
  for (const std::string& gear : gears) teeth[gear] = 12;
  return teeth;
}

/// Values by pointer, in the order in which they are listed.
Defaults defaults(const json& topology) {
  return {{"/ratio_tolerance", 0.01},
          {"/module_mm", {0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.25}},
          {"/planet_count", {3, 4, 5, 6}},
          {"/min_teeth", least_teeth(topology)},
          {"/min_carrier_clearance_rad", 0},
          {"/constraints", "buildable"},
          {"/objective", "mass"},
          {"/friction_coefficient", 0.08},
          {"/materials/density_kg_m3", 7850},
          {"/materials/steel", "case_hardened"},
          {"/synthesis/ring_teeth_off", 1},
          {"/synthesis/min_profile_shift", -0.5},
          {"/synthesis/max_profile_shift", 1},
          {"/synthesis/min_tip_thickness", 0.2},
          {"/synthesis/min_face_width_mm", 1}};
}

/// Where a problem limits no face width. 16 modules are some five circular pitches, the most that
/// textbooks take (Shigley, Mechanical Engineering Design: three to five); and no wider than the
/// smaller gear's diameter, since load lies uneven on wide teeth (GearCalc's manual, 12.7; VDI
/// 2736-2 begins with 0.2 to 2 diameters).
const Defaults& width_defaults() {
  static const Defaults list{{"/synthesis/max_face_width_over_module", 16},
                             {"/synthesis/max_face_width_over_diameter", 1}};
  return list;
}

template <class Json>
bool limits_face_width(const Json& synthesis) {
  return std::any_of(synthesis.items().begin(), synthesis.items().end(),
                     [](const auto& each) { return each.key().starts_with("max_face_width"); });
}

template <class Json>
void assume(const Defaults& list, Json& problem) {
  for (const auto& [pointer, value] : list) {
    const typename Json::json_pointer place(pointer);
    if (problem.contains(place)) continue;
    problem[place] = value;
    problem["assumed"].push_back(pointer);
  }
}

template <class Json>
void assume_all(Json& problem) {
  const bool is_width_limited = limits_face_width(problem["synthesis"]);
  const auto topology = problem.find("topology");
  assume(defaults(topology == problem.end() ? json() : json(*topology)), problem);
  if (!is_width_limited) assume(width_defaults(), problem);
}

bool is_object_or_absent(const json& problem, const char* key) {
  return !problem.contains(key) || problem[key].is_object();
}

}  // namespace

void assume_for_synthesis(json& problem) {
  if (!problem.is_object() || !problem.contains("synthesis")) return;
  if (!is_object_or_absent(problem, "materials") || !problem["synthesis"].is_object()) return;
  if (problem.contains("assumed") && !problem["assumed"].is_array()) return;
  assume_all(problem);
}

nlohmann::ordered_json synthesis_in_few_lines() {
  return {{"kind", "gearbox_problem"},
          {"version", 1},
          {"topology", "3k"},
          {"target_ratio", 20},
          {"rotor_inner_diameter_mm", 79.4},
          {"load", {{"output_torque_Nm", 120}, {"cycles", 1000000}}},
          {"synthesis", {{"gap", 0.001}}}};
}

nlohmann::ordered_json synthesis_to_start_from() {
  nlohmann::ordered_json problem = synthesis_in_few_lines();
  problem["assumed"] = nlohmann::ordered_json::array();
  assume_all(problem);
  return problem;
}

io::Document read_problem_document(const std::string& file) {
  const std::string bytes = io::read_file_bytes(file);
  io::JsonText text = io::read_json_text(bytes, file);
  const bool is_synthesis = text.root.is_object() && text.root.contains("synthesis") &&
                            text.root.value("kind", json()) == "gearbox_problem";
  if (!text.faults.empty() || !is_synthesis) return io::read_document(file, "gearbox_problem");
  assume_for_synthesis(text.root);
  io::Document document = io::check_document(std::move(text.root), "gearbox_problem", file, "");
  document.sha256 = io::sha256(bytes);
  return document;
}

}  // namespace torquewright::gearbox
