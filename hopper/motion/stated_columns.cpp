// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/stated_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "actuator/trajectory/meant_columns.hpp"
#include "hopper/motion/mapping_spec.hpp"
#include "io/documents/document.hpp"

namespace torquewright::hopper {
namespace {

/// Joints, parts of the base and contacts, each once.
std::vector<std::string> owners_of(const std::vector<Channel>& channels) {
  std::vector<std::string> owners;
  for (const Channel& each : channels) {
    const bool is_known = std::find(owners.begin(), owners.end(), each.owner) != owners.end();
    if (!each.owner.empty() && !is_known) owners.push_back(each.owner);
  }
  return owners;
}

}  // namespace

std::vector<StatedColumn> stated_columns(const std::vector<std::string>& mappings,
                                         const std::vector<io::Document>& documents) {
  std::vector<StatedColumn> stated;
  for (const std::string& text : mappings) stated.push_back({actuator::split_mapping(text), text});
  for (const io::Document& document : documents) {
    for (actuator::MappingText& mapping : read_mappings(document)) {
      const std::string text = fmt::format("{} of {}", mapping.column, document.file);
      stated.push_back({std::move(mapping), text});
    }
  }
  return stated;
}

std::vector<StatedColumn> without_patterns(const std::vector<StatedColumn>& stated,
                                           const std::vector<Channel>& channels,
                                           const std::vector<std::string>& header,
                                           const std::string& file) {
  const std::vector<std::string> owners = owners_of(channels);
  std::vector<StatedColumn> all;
  for (const StatedColumn& each : stated) {
    for (const io::PatternColumn& one :
         actuator::meant_columns(each.mapping.column, each.mapping.joint, owners, header, file)) {
      all.push_back(each);
      all.back().mapping.column = one.column;
      all.back().mapping.joint = one.joint;
    }
  }
  return all;
}

}  // namespace torquewright::hopper
