// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace torquewright::io {

/// A column of a table and the joint that it is of.
struct PatternColumn {
  std::string column, joint;
};

/// Whether a column's name is a pattern: it holds a word in braces, as "{leg}_rad" does.
bool is_pattern(const std::string& column);

/// Finds the columns that a pattern stands for: of each joint that `joint_pattern` fits, with what
/// the braces stand for in its name put into the column's. "{joint}" fits any joint. Empty where
/// none fits, or the two do not have one pair of braces with the same word each.
std::vector<PatternColumn> columns_of_pattern(const std::string& column,
                                              const std::string& joint_pattern,
                                              const std::vector<std::string>& joints);

}  // namespace torquewright::io
