// SPDX-License-Identifier: Apache-2.0
#include "io/text/column_patterns.hpp"

#include <optional>

namespace torquewright::io {
namespace {

/// A name around one word in braces.
struct Pattern {
  std::string before, word, after;
};

std::optional<Pattern> pattern_of(const std::string& name) {
  const std::size_t opens = name.find('{');
  const std::size_t closes = name.find('}', opens);
  if (opens == std::string::npos || closes == std::string::npos) return std::nullopt;
  if (name.find('{', opens + 1) != std::string::npos) return std::nullopt;
  return Pattern{name.substr(0, opens), name.substr(opens + 1, closes - opens - 1),
                 name.substr(closes + 1)};
}

}  // namespace

bool is_pattern(const std::string& column) { return pattern_of(column).has_value(); }

std::vector<PatternColumn> columns_of_pattern(const std::string& column,
                                              const std::string& joint_pattern,
                                              const std::vector<std::string>& joints) {
  const auto of_column = pattern_of(column);
  const auto of_joint = pattern_of(joint_pattern);
  std::vector<PatternColumn> columns;
  if (!of_column || !of_joint || of_column->word != of_joint->word) return columns;
  for (const std::string& joint : joints) {
    const std::size_t around = of_joint->before.size() + of_joint->after.size();
    if (joint.size() <= around || !joint.starts_with(of_joint->before) ||
        !joint.ends_with(of_joint->after)) {
      continue;
    }
    const std::string stands = joint.substr(of_joint->before.size(), joint.size() - around);
    columns.push_back({of_column->before + stands + of_column->after, joint});
  }
  return columns;
}

}  // namespace torquewright::io
