// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/table_forms/byte_source.hpp"

namespace torquewright::io {

/// The text of a table of any length, line by line, in flat memory, whatever file holds it
/// (table_bytes.hpp). A byte order mark at its start and a
/// carriage return before a line's end are dropped; the last line needs no end.
class LineReader {
 public:
  /// Throws SpecError if the file is missing, a folder or unreadable.
  explicit LineReader(const std::filesystem::path& file);
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

  /// The next line, valid until the next call; false at the end. Throws SpecError for what is no
  /// text: other formats (foreign_format.hpp), zero bytes (UTF-16), or a line longer than
  /// kLongestLine.
  bool next(std::string_view& line);
  static constexpr std::size_t kLongestLine = std::size_t{1} << 20;

  const std::string& file() const { return file_; }
  std::size_t line_number() const { return line_number_; }  ///< Of the last line; from 1.
  std::string sha256() { return bytes_->sha256(); }         ///< Of the file; at its end, once.
  /// 0...1; 0 where the length is not known (a pipe).
  double share_read() const { return bytes_->share_read(); }
  /// How the file holds the text; empty where it is the text.
  std::string form() const { return bytes_->form(); }
  /// Whether the file has these lines; else the first is made of names.
  bool has_lines() const { return bytes_->has_lines(); }

 private:
  bool fill();
  /// Throws SpecError for an archive, a recording or another format that is no text.
  void refuse_foreign(std::string_view first_bytes) const;
  std::string_view cleaned(std::string_view line) const;

  std::string file_;
  std::unique_ptr<ByteSource> bytes_;
  bool is_begun_ = false;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::size_t line_number_ = 0;
};

}  // namespace torquewright::io
