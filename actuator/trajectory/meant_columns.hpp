// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "actuator/trajectory/columns.hpp"
#include "io/text/column_patterns.hpp"

namespace torquewright::actuator {

/// Returns the columns that a mapping means: the column itself, or where its name is a pattern
/// ("{joint}_pos" of "{joint}", "{leg}_q" of "{leg}_joint"), those in the header of the joints that
/// it fits. Throws io::SpecError, which names the file, where a pattern fits none.
std::vector<io::PatternColumn> meant_columns(const std::string& column, const std::string& joint,
                                             const std::vector<std::string>& joints,
                                             const std::vector<std::string>& header,
                                             const std::string& file);

/// Returns the mappings with one for each joint in the place of a pattern. Throws as above.
std::vector<ColumnMapping> without_patterns(const std::vector<ColumnMapping>& mappings,
                                            const std::vector<std::string>& joints,
                                            const std::vector<std::string>& header,
                                            const std::string& file);

}  // namespace torquewright::actuator
