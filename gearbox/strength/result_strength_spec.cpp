// SPDX-License-Identifier: Apache-2.0
#include "gearbox/strength/result_strength_spec.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "gearbox/strength/problem_strength.hpp"
#include "gearbox/strength/steels.hpp"
#include "gearbox/topologies/topology.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/given_once.hpp"
#include "io/text/one_line.hpp"

namespace torquewright::gearbox {
namespace {

using nlohmann::json;

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
           fmt::format("--design {} is not there; the number of designs is {}", place,
                       designs.size()));
  }
  return designs[place - 1];
}

std::string known_steels() {
  std::string names;
  for (const Steel& steel : steels()) {
    names += (names.empty() ? "" : ", ") + std::string(steel.name);
  }
  return names;
}

const Steel& named_steel(const std::string& name) {
  if (const Steel* steel = find_steel(name)) return *steel;
  io::refuse("--steel", fmt::format("\"{}\" is not known; one of: {}", name, known_steels()));
}

/// All that is missing at once.
void require_steel_and_widths(const io::Document& result, const json& design,
                              const ResultStrengthOptions& options) {
  std::vector<io::Fault> missing;
  if (options.steel.empty()) {
    missing.push_back({result.file, "",
                       fmt::format("a gearbox_result says no steel; say --steel ({}), or write a "
                                   "gear_strength document that names this file",
                                   known_steels())});
  }
  if (options.face_width_mm.empty() && !design.contains("face_width_mm") &&
      !result.root["problem"].contains("face_width_mm")) {
    missing.push_back(
        {result.file, "/problem/face_width_mm", "missing; say --face-width MM (by layer: 10,8)"});
  }
  if (!missing.empty()) throw io::SpecError(std::move(missing));
}

/// "sun=..." in its two parts.
std::pair<std::string, std::string> parts_of(const std::string& option, const std::string& item,
                                             const Topology& topology) {
  const std::size_t sign = item.find('=');
  const std::string gear = item.substr(0, sign);
  if (sign == std::string::npos ||
      std::find(topology.gears.begin(), topology.gears.end(), gear) == topology.gears.end()) {
    io::refuse(option,
               fmt::format("\"{}\" names no gear; {} has {}, as in {}=...", item, topology.name,
                           fmt::join(topology.gears, ", "), topology.gears.front()));
  }
  return {gear, item.substr(sign + 1)};
}

/// One for every gear, in the topology's order.
std::vector<const Steel*> chosen_steels(const io::Document& result, const Topology& topology,
                                        const std::vector<std::string>& stated) {
  const Steel* common = nullptr;
  std::map<std::string, const Steel*, std::less<>> own;
  for (const std::string& item : stated) {
    if (item.find('=') == std::string::npos) {
      if (common != nullptr) io::refuse("--steel", "names two steels for all gears");
      common = &named_steel(item);
    } else {
      const auto [gear, name] = parts_of("--steel", item, topology);
      if (!own.emplace(gear, &named_steel(name)).second) {
        io::refuse("--steel", fmt::format("names two steels for {}", gear));
      }
    }
  }
  std::vector<const Steel*> list;
  for (const std::string_view gear : topology.gears) {
    const auto found = own.find(gear);
    list.push_back(found == own.end() ? common : found->second);
    if (list.back() != nullptr) continue;
    refuse(result, "", fmt::format("--steel names no steel for {}", gear));
  }
  return list;
}

json stated_rims(const Topology& topology, const std::vector<std::string>& stated) {
  io::require_each_once("--rim", stated);
  json rims = json::object();
  for (const std::string& item : stated) {
    const auto [gear, number] = parts_of("--rim", item, topology);
    char* end = nullptr;
    const double thickness_mm = std::strtod(number.c_str(), &end);
    const bool is_decimal = number.find_first_of("xX") == std::string::npos;
    if (number.empty() || !is_decimal || *end != '\0' ||
        !(thickness_mm > 0.0 && thickness_mm <= 1000.0)) {
      io::refuse("--rim", fmt::format("\"{}\": needs a length from 0 to 1000 mm", item));
    }
    rims[gear] = thickness_mm;
  }
  return rims;
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

/// What is stated, or the design's or problem's own (one of them is); one width stands for both
/// layers.
json face_widths(const io::Document& result, const json& design, const std::vector<double>& stated,
                 bool has_second) {
  if (stated.empty())
    return design.value("face_width_mm", result.root["problem"].value("face_width_mm", json()));
  if (stated.size() > (has_second ? 2U : 1U)) {
    refuse(result, "",
           fmt::format("--face-width has {} numbers; this train has {}", stated.size(),
                       has_second ? "two layers" : "one layer"));
  }
  json widths{{"layer_1", stated.front()}};
  if (has_second) widths["layer_2"] = stated.back();
  return widths;
}

json factors_json(const LoadFactors& factors) {
  return {{"application", factors.application},
          {"dynamic", factors.dynamic},
          {"load_sharing", factors.load_sharing},
          {"face_load_root", factors.face_load_root},
          {"face_load_flank", factors.face_load_flank},
          {"alternating_bending", factors.alternating_bending}};
}

/// Every steel once, with the gears that are of it where they are not all.
std::string steel_sentences(const Topology& topology, const std::vector<const Steel*>& chosen) {
  std::string text;
  for (const Steel& steel : steels()) {
    std::vector<std::string_view> gears;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      if (chosen[i] == &steel) gears.push_back(topology.gears[i]);
    }
    if (gears.empty()) continue;
    text += fmt::format(
        "{}Steel {}{}: bending endurance {} MPa, contact endurance {} MPa. {}",
        text.empty() ? "" : "\n", steel.name,
        gears.size() == chosen.size() ? "" : fmt::format(" of {}", fmt::join(gears, ", ")),
        steel.material.bending_endurance_MPa, steel.material.contact_endurance_MPa, steel.source);
  }
  return text;
}

std::string assumed_sentence(const ReadStrength& read, const ResultStrengthOptions& options) {
  const StrengthCase& strength = read.strength;
  const LoadFactors& factors = strength.factors;
  return fmt::format(
      "Assumed: application factor K_A {}, dynamic factor K_v {}, {}face load factors K_Fbeta {} "
      "and K_Hbeta {}, {} of the endurance limit for teeth bent both ways, safeties {} of root and "
      "{} of flank{}{}.",
      factors.application, factors.dynamic,
      options.load_sharing ? ""
                           : fmt::format("load sharing K_gamma {} (of {} planets), ",
                                         factors.load_sharing, strength.train.planet_count),
      factors.face_load_root, factors.face_load_flank, factors.alternating_bending,
      strength.demanded_root_safety, strength.demanded_flank_safety,
      options.cycles ? "" : fmt::format(", {:.6g} loads (--cycles)", strength.cycles),
      options.rim.empty() ? ", rims too thick to matter (--rim)" : "");
}

/// What the problem states of its own steel and loads stands in where nothing is said.
ResultStrengthOptions with_the_problems(ResultStrengthOptions options, const json& problem) {
  const json materials = problem.value("materials", json::object());
  if (options.steel.empty() && materials.contains("steel")) {
    options.steel = {materials["steel"].get<std::string>()};
  }
  const json load = problem.value("load", json::object());
  if (!options.cycles && load.contains("cycles")) options.cycles = load["cycles"].get<double>();
  return options;
}

}  // namespace

ReadStrength strength_of_result(io::Document result, const ResultStrengthOptions& stated) {
  const json design = chosen_design(result, stated.design);
  const ResultStrengthOptions options = with_the_problems(stated, result.root["problem"]);
  require_steel_and_widths(result, design, options);
  const json& problem = result.root["problem"];
  const std::string topology = problem["topology"];
  const Topology& gears = *find_topology(topology);
  const std::vector<const Steel*> chosen = chosen_steels(result, gears, options.steel);
  json keys{{"kind", "gear_strength"}, {"version", 1}};
  keys["name"] = problem.value("name", io::stem_in_text(result.file));
  keys["gearbox"] = {{"topology", topology},
                     {"teeth", design["teeth"]},
                     {"planet_count", design["planet_count"]},
                     {"module_mm", design["module_mm"]}};
  for (const char* own : {"profile_shift", "layer_2_module_mm"}) {
    if (design.contains(own)) keys["gearbox"][own] = design[own];
  }
  if (problem.contains("cutter")) keys["cutter"] = problem["cutter"];
  keys["face_width_mm"] =
      face_widths(result, design, options.face_width_mm, gears.layer_count() == 2);
  keys["material"] = material_json(chosen.front()->material);
  for (std::size_t i = 1; i < chosen.size(); ++i) {
    if (chosen[i] == chosen.front()) continue;
    keys["own_material"][std::string(gears.gears[i])] = material_json(chosen[i]->material);
  }
  if (!options.rim.empty()) keys["rim_mm"] = stated_rims(gears, options.rim);
  keys["factors"] = factors_json(assumed_factors(design["planet_count"].get<std::int64_t>()));
  if (options.load_sharing) keys["factors"]["load_sharing"] = *options.load_sharing;
  keys["cycles"] = static_cast<std::int64_t>(kAssumedCycles);
  keys["safety_factor"] = {{"root", kAssumedRootSafety}, {"flank", kAssumedFlankSafety}};
  keys["rotor_inner_diameter_mm"] = problem["rotor_inner_diameter_mm"];
  keys["assumed"] = {"/factors", "/safety_factor"};
  if (!options.cycles) keys["assumed"].push_back("/cycles");
  ReadStrength read = strength_of(io::check_document(keys, "gear_strength", result.file, ""));
  if (options.cycles) read.strength.cycles = *options.cycles;
  read.statements = {fmt::format("Design {} of {} in {} (status: {}).", options.design,
                                 result.root["designs"].size(), result.file,
                                 result.root["status"].get<std::string>()),
                     steel_sentences(gears, chosen), assumed_sentence(read, options)};
  if (problem.contains("load")) read.load_Nm = problem["load"]["output_torque_Nm"];
  read.documents = {std::move(result)};
  return read;
}

}  // namespace torquewright::gearbox
