// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "io/faults/spec_error.hpp"

namespace torquewright::io {

/// A document as read: of the expected kind and version, and of the shape its schema in
/// specs/schema demands (required keys, types, plausible ranges, no unknown keys). Every pointer in
/// its "assumed" list leads to a value of it.
struct Document {
  std::string file;     ///< As the user named it.
  std::string path;     ///< JSON pointer to it inside the file; empty: it is the whole file.
  nlohmann::json root;  ///< Numbers are finite doubles or integers; 20.0 is the integer 20.
  std::string sha256;   ///< Of the file's bytes; of the canonical text if it came from memory.
};

/// Reads and checks a file. Throws SpecError with every fault of the document: missing, a folder,
/// unreadable, larger than 64 MiB, not JSON, duplicate keys, wrong kind or version, shape, ranges,
/// unknown keys (with the nearest known one).
Document read_document(const std::filesystem::path& file, std::string_view kind);

/// The same for a document that may be of several kinds: it is checked against the kind that it
/// says it is. Requires at least one kind.
Document read_document(const std::filesystem::path& file,
                       std::initializer_list<std::string_view> kinds);

/// The same for a document of any kind there is.
Document read_any_document(const std::filesystem::path& file);

/// The same checks for a document that stands inside another one (a result's "problem"). `file`
/// and `path` say where it stands, for the messages.
Document check_document(nlohmann::json root, std::string_view kind, std::string file,
                        std::string path);

}  // namespace torquewright::io
