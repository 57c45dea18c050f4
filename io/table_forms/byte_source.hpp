// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace torquewright::io {

/// The text of a table, byte after byte, in flat memory, however its file holds it.
class ByteSource {
 public:
  ByteSource() = default;
  virtual ~ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  /// Puts up to `most` of the next bytes there and returns how many; 0 at the end. Throws SpecError
  /// where they cannot be had.
  virtual std::size_t read(char* to, std::size_t most) = 0;
  /// 0...1; 0 where the length is not known (a pipe).
  virtual double share_read() const = 0;
  /// SHA-256 of the file's own bytes; to be asked for at its end, once.
  virtual std::string sha256() = 0;
  /// How the file holds the text, as a piece of a sentence; empty where it is the text.
  virtual std::string form() const { return ""; }
  /// Whether the file has the lines of the text.
  virtual bool has_lines() const { return true; }
};

}  // namespace torquewright::io
