// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "actuator/trajectory/columns.hpp"
#include "hopper/motion/channel.hpp"

namespace torquewright::io {
struct Document;
}

namespace torquewright::hopper {

/// A mapping that the command line or a document states.
struct StatedColumn {
  actuator::MappingText mapping;
  std::string text;  ///< As a refusal repeats it.
};

/// Returns the mappings of the command line, NAME=OWNER.QUANTITY[:unit][*factor], then those of
/// documents of kind trajectory_columns. Throws io::SpecError for one that has not this form.
std::vector<StatedColumn> stated_columns(const std::vector<std::string>& mappings,
                                         const std::vector<io::Document>& documents);

/// Returns the same with a mapping for each owner in the place of a pattern ("{joint}_pos").
/// Throws io::SpecError, which names the file, where a pattern fits no column of the header.
std::vector<StatedColumn> without_patterns(const std::vector<StatedColumn>& stated,
                                           const std::vector<Channel>& channels,
                                           const std::vector<std::string>& header,
                                           const std::string& file);

}  // namespace torquewright::hopper
