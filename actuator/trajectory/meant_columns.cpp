// SPDX-License-Identifier: Apache-2.0
#include "actuator/trajectory/meant_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/faults/refusal.hpp"
#include "io/text/wording.hpp"

namespace torquewright::actuator {

std::vector<io::PatternColumn> meant_columns(const std::string& column, const std::string& joint,
                                             const std::vector<std::string>& joints,
                                             const std::vector<std::string>& header,
                                             const std::string& file) {
  if (!io::is_pattern(column)) return {{column, joint}};
  std::vector<io::PatternColumn> columns = io::columns_of_pattern(column, joint, joints);
  std::erase_if(columns, [&header](const io::PatternColumn& each) {
    return std::find(header.begin(), header.end(), each.column) == header.end();
  });
  if (columns.empty()) {
    io::refuse(file, fmt::format("no column is as \"{}\" says of {}; joints are {}", column,
                                 joint.empty() ? "no joint" : joint, io::listed(joints)));
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
