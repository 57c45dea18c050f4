// SPDX-License-Identifier: Apache-2.0
#include "gearbox/synthesis_defaults_spec.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "io/documents/json_reader.hpp"
#include "io/files/file_bytes.hpp"
#include "io/files/sha256.hpp"

namespace torquewright::gearbox {
namespace {

using nlohmann::json;

/// Values by pointer, in the order in which they are listed.
const std::vector<std::pair<std::string, json>>& defaults() {
  static const std::vector<std::pair<std::string, json>> list{
      {"/ratio_tolerance", 0.01},
      {"/module_mm", {0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.25}},
      {"/planet_count", {3, 4, 5, 6}},
      {"/min_teeth", {{"sun", 12}, {"planet_1", 12}, {"planet_2", 12}}},
      {"/min_carrier_clearance_rad", 0},
      {"/constraints", "buildable"},
      {"/objective", "mass"},
      {"/friction_coefficient", 0.08},
      {"/materials/density_kg_m3", 7850},
      {"/materials/steel", "case_hardened"}};
  return list;
}

bool is_object_or_absent(const json& problem, const char* key) {
  return !problem.contains(key) || problem[key].is_object();
}

}  // namespace

void assume_for_synthesis(json& problem) {
  if (!problem.is_object() || !problem.contains("synthesis")) return;
  if (!is_object_or_absent(problem, "materials")) return;
  if (problem.contains("assumed") && !problem["assumed"].is_array()) return;
  for (const auto& [pointer, value] : defaults()) {
    const json::json_pointer place(pointer);
    if (problem.contains(place)) continue;
    problem[place] = value;
    problem["assumed"].push_back(pointer);
  }
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
