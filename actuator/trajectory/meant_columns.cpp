// SPDX-License-Identifier: Apache-2.0
#include "actuator/trajectory/meant_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/faults/refusal.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"

namespace torquewright::actuator {
namespace {

/// Of the first column that the pattern asks for and that is nearly there.
std::string nearest_hint(const std::vector<io::PatternColumn>& asked,
                         const std::vector<std::string>& header) {
  for (const io::PatternColumn& each : asked) {
    const auto near = io::nearest(each.column, header);
    if (near) return fmt::format("; \"{}\" is near \"{}\", which is there", each.column, *near);
  }
  return "";
}

}  // namespace

std::vector<io::PatternColumn> meant_columns(const std::string& column, const std::string& joint,
                                             const std::vector<std::string>& joints,
                                             const std::vector<std::string>& header,
                                             const std::string& file) {
  if (!io::is_pattern(column)) return {{column, joint}};
  const std::vector<io::PatternColumn> asked = io::columns_of_pattern(column, joint, joints);
  std::vector<io::PatternColumn> columns = asked;
  std::erase_if(columns, [&header](const io::PatternColumn& each) {
    return std::find(header.begin(), header.end(), each.column) == header.end();
  });
  if (columns.empty()) {
    io::refuse(file, fmt::format("no column is as \"{}\" says of {}; joints are {}{}", column,
                                 joint.empty() ? "no joint" : joint, io::listed(joints),
                                 nearest_hint(asked, header)));
  }
  return columns;
}

std::vector<ColumnMapping> without_patterns(const std::vector<ColumnMapping>& mappings,
                                            const std::vector<std::string>& joints,
                                            const std::vector<std::string>& header,
                                            const std::string& file) {
  std::vector<ColumnMapping> all;
  for (const ColumnMapping& mapping : mappings) {
    for (const io::PatternColumn& one :
         meant_columns(mapping.column, mapping.joint, joints, header, file)) {
      all.push_back(mapping);
      all.back().column = one.column;
      all.back().joint = one.joint;
    }
  }
  return all;
}

}  // namespace torquewright::actuator
