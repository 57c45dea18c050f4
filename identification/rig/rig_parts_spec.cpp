// SPDX-License-Identifier: Apache-2.0
#include "identification/rig/rig_parts_spec.hpp"

#include <fmt/format.h>

#include <set>

#include "io/documents/document.hpp"
#include "io/documents/schema.hpp"
#include "io/faults/json_text.hpp"
#include "io/files/file_bytes.hpp"
#include "io/text/name_pattern.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification {
namespace {

using nlohmann::json;

/// A number, or one that may say more of itself.
bool is_number(const json& property) {
  if (property.contains("anyOf")) return is_number(property["anyOf"][0]);
  return property.value("type", "") == "number";
}

/// The numbers among an object's properties as a schema lists them.
std::vector<std::string> numbers_of(const json& schema) {
  std::vector<std::string> names;
  for (const auto& [key, property] : schema["properties"].items()) {
    if (is_number(property)) names.push_back(key);
  }
  return names;
}

/// What may be corrected of a part of an actuator: /motor or /gearbox.
std::vector<std::string> numbers_of_actuator(const std::string& part) {
  const json& schema = io::schema_of("actuator")["properties"][part];
  return numbers_of(schema.contains("anyOf") ? schema["anyOf"][0] : schema);
}

void collect_numbers(const json& value, const std::string& path, std::vector<std::string>& found) {
  if (value.is_number()) found.push_back(path);
  if (value.is_object()) {
    for (const auto& [key, child] : value.items()) {
      collect_numbers(child, io::child_path(path, key), found);
    }
  }
  if (!value.is_array()) return;
  for (std::size_t i = 0; i < value.size(); ++i) {
    collect_numbers(value[i], fmt::format("{}/{}", path, i), found);
  }
}

}  // namespace

std::optional<std::vector<std::string>> columns_as_written(const io::Document& document) {
  using Ordered = nlohmann::ordered_json;
  try {
    const Ordered root = Ordered::parse(io::read_file_bytes(document.file));
    std::vector<std::string> names;
    for (const auto& [name, entry] :
         root.at(Ordered::json_pointer(document.path + "/columns")).items()) {
      names.push_back(name);
    }
    return names;
  } catch (const io::SpecError&) {
    return std::nullopt;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

std::string objection_to_pointer(const std::string& pointer, const json& rig) {
  std::vector<std::string> known;
  if (pointer.starts_with("/load/") && rig.contains("loads")) {
    return fmt::format("{}: the loads are given by run; say of which run, /loads/RUN{}",
                       io::as_written(pointer), pointer.substr(std::string("/load").size()));
  }
  if (pointer.starts_with("/loads/")) {
    if (rig.contains("loads")) collect_numbers(rig["loads"], "/loads", known);
  } else if (pointer.starts_with("/load")) {
    // Those of all types of loads: the contract's own example names one that its type lacks.
    for (const std::string& key : numbers_of(io::schema_of("rig")["properties"]["load"])) {
      known.push_back("/load/" + key);
    }
    const json load = rig.value("load", json::object());
    if (load.contains("links")) collect_numbers(load["links"], "/load/links", known);
  } else if (pointer.starts_with("/controller")) {
    const json by_joint = rig.value("controllers", json::object());
    for (const char* key : {"stiffness_Nm_rad", "damping_Nm_s_rad", "delay_s"}) {
      if (rig.contains("controller")) known.push_back(fmt::format("/controller/{}", key));
      for (const auto& [pattern, law] : by_joint.items()) {
        known.push_back(io::child_path(io::child_path("/controllers", pattern), key));
      }
    }
  } else {
    for (const char* part : {"motor", "gearbox"}) {
      for (const std::string& key : numbers_of_actuator(part)) {
        known.push_back(fmt::format("/{}/{}", part, key));
      }
    }
  }
  for (const std::string& one : known) {
    if (one == pointer) return "";
  }
  if (const auto near = io::nearest(pointer, known)) {
    return fmt::format("{} leads to no value; did you mean {}?", io::as_written(pointer), *near);
  }
  return fmt::format(
      "{} leads to no value; must be a number of this rig's \"load\" (/load/...; by run: "
      "/loads/RUN/...) or "
      "of the actuator's motor or gearbox (/motor/..., /gearbox/...)",
      io::as_written(pointer));
}

std::vector<std::size_t> joints_of_patterns(
    const json& patterns, const std::vector<std::string>& joints,
    const std::function<void(std::size_t place, std::string fault)>& report) {
  std::set<std::size_t> found;
  for (std::size_t place = 0; place < patterns.size(); ++place) {
    const std::string pattern = patterns[place];
    bool fits = false;
    for (std::size_t joint = 0; joint < joints.size(); ++joint) {
      if (!io::fits_pattern(joints[joint], pattern)) continue;
      found.insert(joint);
      fits = true;
    }
    if (fits) continue;
    report(place, fmt::format("\"{}\" fits no joint of the log; they are {}", pattern,
                              io::listed(joints)));
  }
  return {found.begin(), found.end()};
}

}  // namespace torquewright::identification
