// SPDX-License-Identifier: Apache-2.0
#include "io/files/journal_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "io/faults/refusal.hpp"
#include "io/files/direct_output.hpp"
#include "io/files/file_session.hpp"
#include "io/files/staged_file.hpp"

namespace torquewright::io {
namespace {

std::string words_of(int error) { return std::generic_category().message(error); }

// Locks are of bytes far behind any journal's end. The run's is held as long as the file is open:
// alone by one writer, shared by several; that of appending while a line is added.
constexpr off_t kRunsByte = off_t{1} << 62;
constexpr off_t kAppendingByte = kRunsByte + 1;
constexpr off_t kFirstNumbersByte = kRunsByte + 2;

/// Of an open file, so that a child process and a second descriptor have no part in it. 0, or the
/// system's error.
int lock(int descriptor, off_t byte, short kind, int command = F_OFD_SETLK) {
  struct flock range {};
  range.l_type = kind;
  range.l_whence = SEEK_SET;
  range.l_start = byte;
  range.l_len = 1;
  while (::fcntl(descriptor, command, &range) != 0) {
    if (errno != EINTR) return errno;
  }
  return 0;
}

bool is_held_by_another(int error) { return error == EAGAIN || error == EACCES; }

std::string bytes_of(int descriptor, const std::filesystem::path& file, std::size_t from = 0) {
  std::string bytes;
  std::array<char, 1 << 16> chunk;
  while (true) {
    const ssize_t count =
        ::pread(descriptor, chunk.data(), chunk.size(), static_cast<off_t>(from + bytes.size()));
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

/// While it lives no other writer adds a line.
class JournalFile::Appending {
 public:
  explicit Appending(const JournalFile& journal) : journal_(journal) {
    if (journal.writers_ == Writers::kOne) return;
    const int error = lock(journal.descriptor_, kAppendingByte, F_WRLCK, F_OFD_SETLKW);
    if (error != 0) refuse_output(journal.file_, words_of(error));
  }
  ~Appending() {
    if (journal_.writers_ == Writers::kSeveral) lock(journal_.descriptor_, kAppendingByte, F_UNLCK);
  }
  Appending(const Appending&) = delete;
  Appending& operator=(const Appending&) = delete;

 private:
  const JournalFile& journal_;
};

JournalFile::JournalFile(const std::filesystem::path& file, std::string_view first_line,
                         Writers writers)
    : file_(file), writers_(writers) {
  const Target target(file);
  if (target.is_direct) refuse_output(file, "a journal is kept in a file");
  open();
  try {
    const Appending alone(*this);
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
  const bool is_alone = writers_ == Writers::kOne;
  const int error = lock(descriptor_, kRunsByte, is_alone ? F_WRLCK : F_RDLCK);
  // A file system without locks keeps the journal of one writer too.
  if (error == 0 || (is_alone && !is_held_by_another(error))) return;
  ::close(descriptor_);
  refuse_output(file_,
                is_held_by_another(error)
                    ? "another run writes this journal"
                    : "several share it, and its file system has no locks: " + words_of(error));
}

void JournalFile::read(std::string_view first_line) {
  const std::string bytes = bytes_of(descriptor_, file_);
  const std::string begins = std::string(first_line) + '\n';
  if (begins.starts_with(bytes) && bytes.size() < begins.size()) return write(first_line);
  if (!bytes.starts_with(begins)) {
    refuse_output(file_, "it is no journal of this program, and would be lost");
  }
  lines_ = whole_lines(std::string_view(bytes).substr(begins.size()));
  whole_bytes_ = bytes.rfind('\n') + 1;
}

void JournalFile::read_on() {
  const std::string bytes = bytes_of(descriptor_, file_, whole_bytes_);
  for (std::string& line : whole_lines(bytes)) lines_.push_back(std::move(line));
  if (const std::size_t end = bytes.rfind('\n'); end != std::string::npos) whole_bytes_ += end + 1;
}

bool JournalFile::take(std::size_t number) {
  return lock(descriptor_, kFirstNumbersByte + static_cast<off_t>(number), F_WRLCK) == 0;
}

void JournalFile::give_back(std::size_t number) {
  lock(descriptor_, kFirstNumbersByte + static_cast<off_t>(number), F_UNLCK);
}

void JournalFile::add(std::string_view line) {
  const Appending alone(*this);
  if (writers_ == Writers::kSeveral) read_on();
  write(line);
}

void JournalFile::write(std::string_view line) {
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

void check_journal(const std::filesystem::path& file, std::string_view first_line,
                   JournalFile::Writers writers) {
  const Target target(file);
  require_writable(target);
  if (target.exists) JournalFile(file, first_line, writers);
}

}  // namespace torquewright::io
