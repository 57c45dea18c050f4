// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::io {

/// One thing wrong with the user's input: where (file, JSON pointer, possibly empty) and a sentence
/// that names the value and what is allowed.
struct Fault {
  std::string file;
  std::string path;
  std::string message;
};

/// The user's input is wrong: all faults found at once. Caught in main only, exit code 2.
/// what() is one line per fault: `file#/path: message`.
class SpecError : public std::runtime_error {
 public:
  explicit SpecError(std::vector<Fault> faults);
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

/// A document as read: of the expected kind and version, and of the shape its schema in
/// specs/schema demands (required keys, types, plausible ranges, no unknown keys).
struct Document {
  std::string file;       ///< As the user named it.
  nlohmann::json root;    ///< Numbers are finite doubles or integers.
  std::string sha256;     ///< Of the file's bytes; of the canonical text if it came from memory.
};

/// Reads and checks a file. Throws SpecError with every fault of the document: missing, a folder,
/// unreadable, larger than 64 MiB, not JSON, duplicate keys, wrong kind or version, shape, ranges,
/// unknown keys (with the nearest known one).
Document read_document(const std::filesystem::path& file, std::string_view kind);

/// The same checks for a document that stands inside another one (a result's "problem"). `file`
/// and `path` say where it stands, for the messages.
Document check_document(nlohmann::json root, std::string_view kind, std::string file,
                        std::string path);

}  // namespace torquewright::io
