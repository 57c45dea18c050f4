// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::io {

/// Lines that are added one by one, each of them kept from then on, whatever becomes of whoever
/// writes them. A line that was only half written is none. One writer at a time, or several that
/// know of each other; what a writer locks is free again when its process ends, however it ends.
class JournalFile {
 public:
  enum class Writers {
    kOne,
    kSeveral  ///< All of them on one file system, which must have locks of bytes (NFS has).
  };

  /// Opens the file, or makes it, with this first line. Nothing of a journal that exists is changed
  /// before a line is added. Throws SpecError: it holds something else, is an input of this
  /// session, is written by another program, or cannot be read and written.
  JournalFile(const std::filesystem::path& file, std::string_view first_line,
              Writers writers = Writers::kOne);
  ~JournalFile();
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  /// Returns the lines that stood there when it was opened, after the first one, and those that
  /// read_on() found.
  const std::vector<std::string>& lines() const { return lines_; }
  /// Reads what other writers have added since, to the end of lines().
  void read_on();

  /// Adds a line, which is kept when this returns (fsync). Requires a line without a line break.
  /// Throws SpecError where it cannot be written.
  void add(std::string_view line);

  /// Takes a number for this writer alone; false where another has it. Requires Writers::kSeveral.
  bool take(std::size_t number);
  void give_back(std::size_t number);

 private:
  class Appending;

  void open();
  void read(std::string_view first_line);
  void write(std::string_view line);

  std::filesystem::path file_;
  Writers writers_;
  int descriptor_ = -1;
  std::vector<std::string> lines_;
  std::size_t whole_bytes_ = 0;  ///< Up to the last line break.
};

/// Throws SpecError where a journal could not be kept in that file, as far as that shows without
/// making it: for before the work.
void check_journal(const std::filesystem::path& file, std::string_view first_line,
                   JournalFile::Writers writers = JournalFile::Writers::kOne);

}  // namespace torquewright::io
