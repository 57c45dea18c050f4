// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "io/files/file_session.hpp"
#include "io/files/sha256.hpp"
#include "io/table_forms/byte_source.hpp"

namespace torquewright::io {

/// A file's bytes as they stand.
class PlainBytes : public ByteSource {
 public:
  /// Throws SpecError if the file is missing, a folder or unreadable.
  explicit PlainBytes(const std::filesystem::path& file);

  /// The first bytes, up to 256, by which formats are told; they are read all the same.
  std::string_view first_bytes() const { return first_; }
  /// Whether it can be read from any place and more than once: no pipe, no device.
  bool is_plain_file() const { return size_bytes_ > 0.0; }

  std::size_t read(char* to, std::size_t most) override;
  double share_read() const override;
  std::string sha256() override { return hash_.digest(); }

 private:
  std::size_t read_from_file(char* to, std::size_t most);

  std::string file_;
  InputFile input_;
  double size_bytes_ = 0.0;  ///< 0: not known.
  double bytes_read_ = 0.0;
  Sha256 hash_;
  std::string first_;
  std::size_t given_of_first_ = 0;
};

}  // namespace torquewright::io
