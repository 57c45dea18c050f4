// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace torquewright::io {

/// A document that was read, and what it lists as assumed.
struct ReadNote {
  std::string file;
  std::string kind;
  std::vector<std::string> assumed;
};

/// From now on each document that is read is noted, in the order of reading, each file once; what
/// was noted before is forgotten.
void keep_read_notes();
std::vector<ReadNote> read_notes();

/// By whoever reads a document, whose text is `root`.
void note_read(const std::string& file, const nlohmann::json& root);

}  // namespace torquewright::io
