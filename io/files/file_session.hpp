// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <string_view>
#include <vector>

namespace torquewright::io {

/// One run of a program: while it lasts, every file that is opened for reading is remembered, and
/// none of them is replaced by an output, nor any file to which one of them leads by the names that
/// documents hold, read or not, under whatever name (docs/decisions/0016). At most one at a time;
/// without one, as in a library's hands, files are read and written as they come.
class FileSession {
 public:
  FileSession();
  ~FileSession();
  FileSession(const FileSession&) = delete;
  FileSession& operator=(const FileSession&) = delete;
};

/// A file open for reading; closes itself. Throws SpecError: it is missing, unreadable, a folder,
/// or a named pipe into which nobody writes for kWriterPatience_s.
class InputFile {
 public:
  explicit InputFile(const std::filesystem::path& file);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  int descriptor() const { return descriptor_; }
  const struct stat& status() const { return status_; }

 private:
  int descriptor_;
  struct stat status_ {};
};

/// How long named pipes are waited for, all of one run together. The shell's own (`<(...)`) have no
/// such limit.
inline constexpr int kWriterPatience_s = 5;

/// A file as it was when it was read.
struct ReadFile {
  std::filesystem::path file;
  struct stat status {};
};

/// The files that were read in this session, in the order of reading.
std::vector<ReadFile> files_read();

/// Begins the session again, for work that is done again: no file was read.
void forget_files_read();

/// Remembers the files that a document names as inputs, for one whose text cannot be read again,
/// from a pipe.
void remember_names(const std::filesystem::path& document, std::string_view text);

/// Whether the file at that path was read in this session, or what was read leads to it.
bool is_input(const std::filesystem::path& file);
/// Whether what is open as that descriptor is an input.
bool is_input(int descriptor);

}  // namespace torquewright::io
