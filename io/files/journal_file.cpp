// SPDX-License-Identifier: Apache-2.0
#include "io/files/journal_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "io/faults/refusal.hpp"
#include "io/files/direct_output.hpp"
#include "io/files/file_session.hpp"
#include "io/files/staged_file.hpp"

namespace torquewright::io {
namespace {

std::string words_of(int error) { return std::generic_category().message(error); }

std::string bytes_of(int descriptor, const std::filesystem::path& file) {
  std::string bytes;
  std::array<char, 1 << 16> chunk;
  while (true) {
    const ssize_t count =
        ::pread(descriptor, chunk.data(), chunk.size(), static_cast<off_t>(bytes.size()));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse_unreadable(file.string(), errno);
    if (count == 0) return bytes;
    bytes.append(chunk.data(), static_cast<std::size_t>(count));
  }
}

/// Those that end in a line break.
std::vector<std::string> whole_lines(std::string_view bytes) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0;;) {
    const std::size_t end = bytes.find('\n', begin);
    if (end == std::string_view::npos) return lines;
    lines.emplace_back(bytes.substr(begin, end - begin));
    begin = end + 1;
  }
}

}  // namespace

JournalFile::JournalFile(const std::filesystem::path& file, std::string_view first_line)
    : file_(file) {
  const Target target(file);
  if (target.is_direct) refuse_output(file, "a journal is kept in a file");
  open();
  try {
    read(first_line);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

JournalFile::~JournalFile() { ::close(descriptor_); }

void JournalFile::open() {
  descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) refuse_output(file_, words_of(errno));
  // A file system without locks keeps journals too.
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(descriptor_);
  refuse_output(file_, "another run writes this journal");
}

void JournalFile::read(std::string_view first_line) {
  const std::string bytes = bytes_of(descriptor_, file_);
  const std::string begins = std::string(first_line) + '\n';
  if (begins.starts_with(bytes) && bytes.size() < begins.size()) return add(first_line);
  if (!bytes.starts_with(begins)) {
    refuse_output(file_, "it is no journal of this program, and would be lost");
  }
  lines_ = whole_lines(std::string_view(bytes).substr(begins.size()));
  whole_bytes_ = bytes.rfind('\n') + 1;
}

void JournalFile::add(std::string_view line) {
  const std::string bytes = std::string(line) + '\n';
  const auto end = static_cast<off_t>(whole_bytes_);
  // What was half written goes; so does this line, where it cannot be written whole.
  if (::ftruncate(descriptor_, end) != 0 || ::lseek(descriptor_, end, SEEK_SET) < 0) {
    refuse_output(file_, words_of(errno));
  }
  int error = write_all(descriptor_, bytes);
  if (error == 0 && ::fsync(descriptor_) != 0) error = errno;
  if (error != 0) {
    const bool is_cut = ::ftruncate(descriptor_, end) == 0;
    refuse_output(file_, words_of(error) + (is_cut ? "" : "; its last line is half written"));
  }
  whole_bytes_ += bytes.size();
}

void check_journal(const std::filesystem::path& file, std::string_view first_line) {
  const Target target(file);
  require_writable(target);
  if (target.exists) JournalFile(file, first_line);
}

}  // namespace torquewright::io
