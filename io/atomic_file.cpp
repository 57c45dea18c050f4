// SPDX-License-Identifier: Apache-2.0
#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <string>
#include <system_error>

#include "io/spec_error.hpp"

namespace torquewright::io {
namespace {

namespace fs = std::filesystem;

/// Readable and writable for all whom the process's umask admits, as for any new file.
constexpr mode_t kNewFileMode = 0666;

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw SpecError({{file.string(), "", "cannot be written: " + why}});
}

std::string reason(int error) { return std::generic_category().message(error); }

/// 0, or the errno of what failed. Closes the descriptor in any case.
int write_and_close(int descriptor, std::string_view content, bool is_disk_file) {
  int error = 0;
  while (!content.empty() && error == 0) {
    const ssize_t count = ::write(descriptor, content.data(), content.size());
    if (count >= 0) {
      content.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      error = errno;
    }
  }
  if (error == 0 && is_disk_file && ::fsync(descriptor) != 0) error = errno;
  // Network file systems report a full disk as late as here.
  if (::close(descriptor) != 0 && error == 0) error = errno;
  return error;
}

/// In the same folder, since only there can the rename be atomic; a name that nobody else has.
fs::path temporary_beside(const fs::path& file) {
  static std::atomic<unsigned> count{0};
  return file.parent_path() / fmt::format(".torquewright-{}-{}.tmp", ::getpid(), ++count);
}

void write_directly(const fs::path& file, std::string_view content) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) refuse(file, reason(errno));
  if (const int error = write_and_close(descriptor, content, false)) refuse(file, reason(error));
}

void write_and_rename(const fs::path& file, const fs::path& target, std::string_view content) {
  const fs::path temporary = temporary_beside(target);
  const int descriptor =
      ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kNewFileMode);
  if (descriptor < 0) {
    refuse(file, errno == ENOENT ? "its folder does not exist" : reason(errno));
  }
  int error = write_and_close(descriptor, content, true);
  if (error == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
  if (error == 0) return;
  ::unlink(temporary.c_str());
  refuse(file, reason(error));
}

}  // namespace

void write_whole_file(const fs::path& file, std::string_view content) {
  if (!file.has_filename()) refuse(file, "a file's name is missing");
  std::error_code unknown;
  const fs::file_status status = fs::status(file, unknown);
  if (fs::is_directory(status)) refuse(file, "it is a folder");
  if (fs::is_other(status)) return write_directly(file, content);
  const fs::path target = fs::is_symlink(fs::symlink_status(file, unknown)) && fs::exists(status)
                              ? fs::canonical(file)
                              : file;
  write_and_rename(file, target, content);
}

void ignore_file_size_signal() { std::signal(SIGXFSZ, SIG_IGN); }

}  // namespace torquewright::io
