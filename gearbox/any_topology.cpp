// SPDX-License-Identifier: Apache-2.0
#include "gearbox/any_topology.hpp"

#include <algorithm>

namespace torquewright::gearbox {
namespace {

bool is_one_of(std::string_view topology, const TrainParts& parts) {
  return topology == kAnyTopology || topology == parts.name;
}

void add_once(const std::string& name, std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

}  // namespace

std::vector<std::string> gears_with_minima(std::string_view topology) {
  std::vector<std::string> names;
  for (const TrainParts& parts : all_train_parts()) {
    if (!is_one_of(topology, parts)) continue;
    for (std::size_t gear = 0; gear < parts.free_gears; ++gear) {
      add_once(std::string(parts.gears[gear]), names);
    }
  }
  return names;
}

std::vector<std::string> layers_of(std::string_view topology) {
  std::vector<std::string> names;
  for (const TrainParts& parts : all_train_parts()) {
    if (!is_one_of(topology, parts)) continue;
    for (const std::string& layer : parts.layer_names()) add_once(layer, names);
  }
  return names;
}

Problem as_topology(const Problem& problem, const TrainParts& parts) {
  Problem own = problem;
  own.topology = parts.name;
  const std::vector<std::string> gears = gears_with_minima(parts.name);
  std::erase_if(own.min_teeth, [&](const auto& minimum) {
    return std::find(gears.begin(), gears.end(), minimum.first) == gears.end();
  });
  if (own.synthesis && parts.layer_count() < 2) own.synthesis->layer_2_module_mm.clear();
  return own;
}

}  // namespace torquewright::gearbox
