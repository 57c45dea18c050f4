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
#include "hopper/motion/stated_columns.hpp"
#include "io/files/csv.hpp"
#include "io/text/nearest.hpp"

namespace torquewright::hopper {
namespace {

using actuator::MappingText;

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
                                                   const std::vector<StatedColumn>& stated,
                                                   std::vector<Channel> channels) {
  std::set<std::string> read{"t", "time"};
  std::set<std::size_t> filled;
  for (const StatedColumn& each : stated) {
    read.insert(each.mapping.column);
    filled.insert(find_channel(each.mapping, each.mapping.column, channels).channel);
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
  const std::vector<StatedColumn> stated = stated_columns(source.mappings, source.documents);
  std::vector<MappingText> mappings;
  for (const StatedColumn& each : stated) mappings.push_back(each.mapping);
  std::vector<actuator::Finding> findings = actuator::unit_findings(mappings);
  if (!source.bare.order.empty()) return findings;  // a column that is not read is called skip
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(source.file, unknown)) return findings;
  const io::CsvReader csv(source.file, io::CsvReader::CutEnd::kRefused,
                          io::CsvReader::UnitsRow::kTaken);
  for (actuator::Finding& finding : actuator::table_findings(csv)) {
    findings.push_back(std::move(finding));
  }
  const std::vector<Channel> channels = channels_of(robot);
  const auto spread = without_patterns(stated, channels, csv.header(), csv.file());
  for (actuator::Finding& finding :
       actuator::unread_findings(unread_columns(csv.header(), spread, channels))) {
    findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace torquewright::hopper
