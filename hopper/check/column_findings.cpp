// SPDX-License-Identifier: Apache-2.0
#include "hopper/check/column_findings.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "actuator/check/column_findings.hpp"
#include "hopper/motion/channel.hpp"
#include "hopper/motion/mapping_spec.hpp"
#include "io/files/csv.hpp"
#include "io/text/nearest.hpp"

namespace torquewright::hopper {
namespace {

using actuator::MappingText;

std::vector<MappingText> stated_mappings(const MotionFile& source) {
  std::vector<MappingText> stated;
  for (const std::string& text : source.mappings) stated.push_back(actuator::split_mapping(text));
  for (const io::Document& document : source.documents) {
    for (MappingText& mapping : read_mappings(document)) stated.push_back(std::move(mapping));
  }
  return stated;
}

/// The missing header of the column's owner that it may be a misspelling of; empty: none.
std::string meant_header(const std::string& column, const std::vector<Channel>& missing) {
  std::vector<std::string> of_its_owner;
  for (const Channel& channel : missing) {
    const bool is_owner = !channel.owner.empty() && column.starts_with(channel.owner);
    if (is_owner) of_its_owner.push_back(channel.header);
  }
  return io::nearest(column, of_its_owner).value_or("");
}

std::vector<actuator::UnreadColumn> unread_columns(const std::vector<std::string>& header,
                                                   const std::vector<MappingText>& stated,
                                                   std::vector<Channel> channels) {
  std::set<std::string> read{"t", "time"};
  std::set<std::size_t> filled;
  for (const MappingText& mapping : stated) {
    read.insert(mapping.column);
    filled.insert(find_channel(mapping, mapping.column, channels).channel);
  }
  std::vector<Channel> missing;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (filled.contains(i)) continue;
    const std::string& name = channels[i].header;
    if (std::find(header.begin(), header.end(), name) == header.end()) {
      missing.push_back(channels[i]);
    } else {
      read.insert(name);
    }
  }
  std::vector<actuator::UnreadColumn> unread;
  for (const std::string& column : header) {
    if (!read.contains(column)) unread.push_back({column, meant_header(column, missing)});
  }
  return unread;
}

}  // namespace

std::vector<actuator::Finding> column_findings(const Robot& robot, const MotionFile& source) {
  const std::vector<MappingText> stated = stated_mappings(source);
  std::vector<actuator::Finding> findings = actuator::unit_findings(stated);
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(source.file, unknown)) return findings;
  const io::CsvReader csv(source.file);
  for (actuator::Finding& finding :
       actuator::unread_findings(unread_columns(csv.header(), stated, channels_of(robot)))) {
    findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace torquewright::hopper
