// SPDX-License-Identifier: Apache-2.0
#include "actuator/motor/gearbox_source_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "actuator/motor/gear_transmission.hpp"
#include "gearbox/problem_spec.hpp"
#include "gearbox/topologies/topology.hpp"
#include "io/documents/document.hpp"
#include "io/text/rational.hpp"

namespace torquewright::actuator {
namespace {

using nlohmann::json;

/// What the evaluation of a gearbox asks for.
struct Gearbox {
  gearbox::Problem problem;
  gearbox::Design design;
};

[[noreturn]] void refuse(const io::Document& document, const std::string& path,
                         std::string message) {
  throw io::SpecError({{document.file, document.path + path, std::move(message)}});
}

/// All tooth counts in the topology's order.
std::vector<std::int64_t> teeth_of(const json& teeth, const gearbox::Topology& topology,
                                   const io::Document& document, const std::string& path) {
  std::vector<std::int64_t> counts;
  for (const std::string_view gear : topology.gears) {
    const std::string name(gear);
    if (!teeth.contains(name)) {
      refuse(document, path + "/" + name,
             fmt::format("missing; the topology \"{}\" has it", topology.name));
    }
    counts.push_back(teeth[name]);
  }
  return counts;
}

gearbox::Design design_of(const json& root, const gearbox::Topology& topology,
                          const io::Document& document, const std::string& path) {
  gearbox::Design design{teeth_of(root["teeth"], topology, document, path + "/teeth"),
                         root["planet_count"], io::exact(root["module_mm"].get<double>())};
  const json shifts = root.value("profile_shift", json::object());
  for (const std::string_view gear : topology.gears) {
    design.profile_shift.push_back(shifts.value(std::string(gear), 0.0));
  }
  if (std::all_of(design.profile_shift.begin(), design.profile_shift.end(),
                  [](double shift) { return shift == 0.0; })) {
    design.profile_shift.clear();
  }
  if (root.contains("layer_2_module_mm") && topology.layer_count() == 2) {
    design.layer_2_module_mm = io::exact(root["layer_2_module_mm"].get<double>());
  }
  return design;
}

/// Those of a document or of a design that has its own.
void take_face_widths(const json& keys, gearbox::Problem& problem) {
  const json widths = keys.value("face_width_mm", json::object());
  for (const auto& width : widths.items()) {
    problem.face_width_mm[width.key()] = io::exact(width.value().get<double>());
  }
}

Gearbox from_result(const io::Document& document) {
  if (document.root["designs"].empty()) {
    refuse(document, "/designs", "holds no design: there is no gearbox to take");
  }
  Gearbox gearbox;
  gearbox.problem = gearbox::read_problem(
      io::check_document(document.root["problem"], "gearbox_problem", document.file, "/problem"));
  const gearbox::Topology& topology = *gearbox::find_topology(gearbox.problem.topology);
  const json& best = document.root["designs"][0];
  gearbox.design = design_of(best, topology, document, "/designs/0");
  take_face_widths(best, gearbox.problem);
  return gearbox;
}

Gearbox from_gearbox(const io::Document& document) {
  const json& root = document.root;
  Gearbox gearbox;
  gearbox.problem.topology = root["topology"];
  gearbox.problem.name = root.value("name", "");
  // No limits are asked of a gearbox that exists: the widest ones.
  gearbox.problem.target_ratio = 1;
  gearbox.problem.rotor_inner_diameter_mm = 1000000;
  gearbox.problem.constraints = gearbox::ConstraintSet::kBuildable;
  gearbox.problem.objective = gearbox::Objective::kHollowShaft;
  const gearbox::Topology& topology = *gearbox::find_topology(gearbox.problem.topology);
  for (std::size_t i = 0; i < topology.free_gears; ++i) {
    gearbox.problem.min_teeth[std::string(topology.gears[i])] = 1;
  }
  take_face_widths(root, gearbox.problem);
  gearbox.design = design_of(root, topology, document, "");
  gearbox.problem.planet_count = {gearbox.design.planet_count};
  gearbox.problem.module_mm = {gearbox.design.module_mm};
  return gearbox;
}

io::Document gearbox_document(const std::string& name, const io::Document& actuator,
                              std::span<const io::Document> read_before) {
  const std::filesystem::path file = std::filesystem::path(actuator.file).parent_path() / name;
  for (const io::Document& document : read_before) {
    if (document.file == file) return document;
  }
  std::error_code unknown;
  if (!std::filesystem::exists(file, unknown)) {
    refuse(actuator, "/gearbox/file",
           fmt::format("\"{}\": no such file, seen from this document", name));
  }
  return io::read_document(file, {"gearbox", "gearbox_result"});
}

}  // namespace

Transmission transmission_from_file(const json& reference, const io::Document& actuator,
                                    std::span<const io::Document> read_before,
                                    std::vector<io::Document>& documents) {
  const io::Document document = gearbox_document(reference["file"], actuator, read_before);
  Gearbox gearbox =
      document.root["kind"] == "gearbox" ? from_gearbox(document) : from_result(document);
  if (reference.contains("friction_coefficient")) {
    gearbox.problem.friction_coefficient =
        io::exact(reference["friction_coefficient"].get<double>());
  }
  if (!gearbox.problem.friction_coefficient) {
    refuse(actuator, "/gearbox/friction_coefficient",
           fmt::format("missing; {} states none, and efficiencies follow from it", document.file));
  }
  const GearTransmission train = gear_transmission(gearbox.problem, gearbox.design);
  if (!train.objection.empty()) refuse(document, train.place, train.objection);
  Transmission transmission = train.transmission;
  transmission.source = document.file;
  documents.push_back(document);
  return transmission;
}

}  // namespace torquewright::actuator
