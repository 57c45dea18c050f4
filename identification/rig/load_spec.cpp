// SPDX-License-Identifier: Apache-2.0
#include "identification/rig/load_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "io/text/wording.hpp"

namespace torquewright::identification {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 6> kLoadNames = {"dynamometer", "free",       "pendulum",
                                                        "linear_axis", "serial_arm", "robot"};

using Keys = std::vector<std::string>;

/// The keys of a load, besides its type, that the types need.
const Keys& keys_of(LoadType type) {
  static const std::array<Keys, 6> kKeys = {{{},
                                             {"inertia_kg_m2"},
                                             {"mass_kg", "length_m", "inertia_kg_m2"},
                                             {"mass_kg"},
                                             {"links"},
                                             {"file"}}};
  return kKeys[static_cast<std::size_t>(type)];
}

/// All that may stand there beside the type.
Keys allowed_keys_of(LoadType type) {
  Keys keys = keys_of(type);
  if (type == LoadType::kDynamometer) keys.emplace_back("steady");
  if (type == LoadType::kRobot) {
    keys.insert(keys.end(), {"base", "held_rad", "roll_rad", "pitch_rad"});
  }
  return keys;
}

}  // namespace

std::string_view name_of(LoadType type) { return kLoadNames[static_cast<std::size_t>(type)]; }

Load load_of_json(const json& load,
                  const std::function<void(const std::string&, std::string)>& report) {
  Load read;
  const auto found = std::find(kLoadNames.begin(), kLoadNames.end(), load["type"]);
  read.type = static_cast<LoadType>(found - kLoadNames.begin());
  const std::vector<std::string>& needed = keys_of(read.type);
  for (const std::string& key : needed) {
    if (load.contains(key)) continue;
    report("/" + key, fmt::format("missing; a load of type \"{}\" needs it", *found));
  }
  const Keys allowed = allowed_keys_of(read.type);
  for (const auto& [key, value] : load.items()) {
    if (key == "type" || std::find(allowed.begin(), allowed.end(), key) != allowed.end()) continue;
    report("/" + key,
           fmt::format("has no meaning for a load of type \"{}\", which {}", *found,
                       allowed.empty() ? "has no values" : "has " + io::listed(allowed)));
  }
  read.mass_kg = load.value("mass_kg", 0.0);
  read.length_m = load.value("length_m", 0.0);
  read.inertia_kg_m2 = load.value("inertia_kg_m2", 0.0);
  read.is_steady = load.value("steady", false);
  read.roll_rad = load.value("roll_rad", 0.0);
  read.pitch_rad = load.value("pitch_rad", 0.0);
  for (const json& link : load.value("links", json::array())) {
    read.links.push_back(
        {link["mass_kg"], link["length_m"], link["center_of_mass_m"], link["inertia_kg_m2"]});
  }
  return read;
}

std::vector<std::string> joints_of_links(const json& load) {
  std::vector<std::string> joints;
  for (const json& link : load.value("links", json::array())) {
    if (link.contains("joint")) joints.push_back(link["joint"]);
  }
  return joints;
}

}  // namespace torquewright::identification
