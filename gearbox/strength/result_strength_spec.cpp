// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/result_strength_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "gearbox/strength/steels.hpp"

namespace torquewright::gearbox {
namespace {

using nlohmann::json;

constexpr std::int64_t kAssumedCycles = 10000;

[[noreturn]] void refuse(const io::Document& result, const std::string& path, std::string message) {
  throw io::SpecError({{result.file, path, std::move(message)}});
}

const json& chosen_design(const io::Document& result, std::size_t place) {
  const json& designs = result.root["designs"];
  const std::string status = result.root["status"];
  if (designs.empty()) {
    refuse(result, "/designs",
           status == "infeasible" ? "holds no design: the problem is infeasible"
                                  : "holds no design: the search ended before it found one");
  }
  if (status == "infeasible") {
    refuse(result, "/status", "infeasible: its design violates the problem's constraints");
  }
  if (place < 1 || place > designs.size()) {
    refuse(result, "/designs",
           fmt::format("--design {} is not there; it holds {}", place, designs.size()));
  }
  return designs[place - 1];
}

const Steel& chosen_steel(const io::Document& result, const std::string& name) {
  if (const Steel* steel = find_steel(name)) return *steel;
  std::string names;
  for (const Steel& steel : steels())
    names += (names.empty() ? "" : ", ") + std::string(steel.name);
  refuse(result, "",
         name.empty() ? fmt::format("a gearbox_result says no steel; say --steel ({}), or write a "
                                    "gear_strength document that names this file",
                                    names)
                      : fmt::format("--steel \"{}\" is not known; one of: {}", name, names));
}

json material_json(const GearMaterial& material) {
  const char* treatment = material.treatment == Treatment::kCaseHardened      ? "case_hardened"
                          : material.treatment == Treatment::kThroughHardened ? "through_hardened"
                                                                              : "nitrided";
  json keys{{"treatment", treatment},
            {"young_MPa", material.young_MPa},
            {"poisson", material.poisson},
            {"bending_endurance_MPa", material.bending_endurance_MPa},
            {"contact_endurance_MPa", material.contact_endurance_MPa}};
  if (material.yield_MPa) keys["yield_MPa"] = *material.yield_MPa;
  return keys;
}

/// What is stated, or the problem's own; one width stands for both layers.
json face_widths(const io::Document& result, const std::vector<double>& stated, bool has_second) {
  const json& problem = result.root["problem"];
  if (stated.empty()) {
    if (problem.contains("face_width_mm")) return problem["face_width_mm"];
    refuse(result, "/problem/face_width_mm", "missing; say --face-width MM (by layer: 10,8)");
  }
  if (stated.size() > (has_second ? 2U : 1U)) {
    refuse(result, "",
           fmt::format("--face-width has {} numbers; this train has {}", stated.size(),
                       has_second ? "two layers" : "one layer"));
  }
  json widths{{"layer_1", stated.front()}};
  if (has_second) widths["layer_2"] = stated.back();
  return widths;
}

/// K_gamma, docs/derivations/strength.md "A result instead of a document".
double assumed_load_sharing(int planets) {
  return planets <= 3   ? 1.1
         : planets == 4 ? 1.25
         : planets == 5 ? 1.35
         : planets == 6 ? 1.44
                        : 1.47;
}

/// Factors and safeties of the examples in specs/gearbox.
json assumed_factors(int planets) {
  return {{"application", 1.0},
          {"dynamic", 1.0},
          {"load_sharing", assumed_load_sharing(planets)},
          {"face_load_root", 1.2},
          {"face_load_flank", 1.3},
          {"alternating_bending", 0.7}};
}

std::string assumed_sentence(const ReadStrength& read, bool assumes_cycles) {
  const StrengthCase& strength = read.strength;
  const LoadFactors& factors = strength.factors;
  return fmt::format(
      "Assumed: K_A {}, K_v {}, K_gamma {} (of {} planets), K_Fbeta {}, K_Hbeta {}, {} of the "
      "endurance limit for teeth bent both ways, safeties {} of root and {} of flank{}.",
      factors.application, factors.dynamic, factors.load_sharing, strength.train.planet_count,
      factors.face_load_root, factors.face_load_flank, factors.alternating_bending,
      strength.demanded_root_safety, strength.demanded_flank_safety,
      assumes_cycles ? fmt::format(", {:.6g} loads (--cycles)", strength.cycles) : "");
}

}  // namespace

ReadStrength strength_of_result(io::Document result, const ResultStrengthOptions& options) {
  const json design = chosen_design(result, options.design);
  const Steel& steel = chosen_steel(result, options.steel);
  const json& problem = result.root["problem"];
  const std::string topology = problem["topology"];
  json keys{{"kind", "gear_strength"}, {"version", 1}};
  keys["name"] = problem.value("name", std::filesystem::path(result.file).stem().string());
  keys["gearbox"] = {{"topology", topology},
                     {"teeth", design["teeth"]},
                     {"planet_count", design["planet_count"]},
                     {"module_mm", design["module_mm"]}};
  if (problem.contains("cutter")) keys["cutter"] = problem["cutter"];
  keys["face_width_mm"] = face_widths(result, options.face_width_mm, layer_count(topology) == 2);
  keys["material"] = material_json(steel.material);
  keys["factors"] = assumed_factors(design["planet_count"]);
  keys["cycles"] = kAssumedCycles;
  keys["safety_factor"] = {{"root", 1.4}, {"flank", 1.0}};
  keys["rotor_inner_diameter_mm"] = problem["rotor_inner_diameter_mm"];
  keys["assumed"] = {"/factors", "/safety_factor"};
  if (!options.cycles) keys["assumed"].push_back("/cycles");
  ReadStrength read = strength_of(io::check_document(keys, "gear_strength", result.file, ""));
  if (options.cycles) read.strength.cycles = *options.cycles;
  read.statements = {fmt::format("Design {} of {} in {} (status: {}).", options.design,
                                 result.root["designs"].size(), result.file,
                                 result.root["status"].get<std::string>()),
                     fmt::format("Steel {}: bending endurance {} MPa, contact endurance {} MPa. {}",
                                 steel.name, steel.material.bending_endurance_MPa,
                                 steel.material.contact_endurance_MPa, steel.source),
                     assumed_sentence(read, !options.cycles)};
  read.documents = {std::move(result)};
  return read;
}

}  // namespace torquewright::gearbox
