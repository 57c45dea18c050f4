// SPDX-License-Identifier: Apache-2.0
#include "io/files/direct_output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <string>
#include <system_error>
#include <thread>

#include "io/faults/refusal.hpp"

namespace torquewright::io {
namespace {

std::optional<int> number_after(std::string_view path, std::string_view folder) {
  if (!path.starts_with(folder)) return std::nullopt;
  path.remove_prefix(folder.size());
  int number = 0;
  const auto [end, error] = std::from_chars(path.data(), path.data() + path.size(), number);
  const bool is_number = error == std::errc() && end == path.data() + path.size() && number >= 0;
  return is_number ? std::optional(number) : std::nullopt;
}

std::optional<int> spelt_descriptor(const std::string& path) {
  if (path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const char* folder : {"/dev/fd/", "/proc/self/fd/", "/proc/thread-self/fd/"}) {
    if (const auto number = number_after(path, folder)) return number;
  }
  return std::nullopt;
}

bool is_named_pipe(const std::filesystem::path& file) {
  struct stat status {};
  return ::stat(file.c_str(), &status) == 0 && S_ISFIFO(status.st_mode);
}

/// Opened for good when a reader has opened it too.
int opened_pipe(const std::filesystem::path& file) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kLookAgain{20};
  const auto deadline = Clock::now() + std::chrono::seconds(kReaderPatience_s);
  int descriptor = -1;
  while ((descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK)) < 0) {
    if (errno != ENXIO && errno != EINTR) return -1;
    if (Clock::now() > deadline) {
      refuse_output(file, fmt::format("it is a named pipe, and nobody read from it within {} s",
                                      kReaderPatience_s));
    }
    std::this_thread::sleep_for(kLookAgain);
  }
  ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
  return descriptor;
}

/// To be closed: a second one of the same open file, or a new one.
int opened(const std::filesystem::path& file) {
  if (const std::optional<int> named = named_descriptor(file)) {
    return ::fcntl(*named, F_DUPFD_CLOEXEC, 0);
  }
  return is_named_pipe(file) ? opened_pipe(file) : ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
}

}  // namespace

std::optional<int> named_descriptor(const std::filesystem::path& file) {
  constexpr int kMostLinks = 40;  // as many as the system follows
  std::filesystem::path path = file;
  for (int links = 0; links < kMostLinks; ++links) {
    if (const auto spelt = spelt_descriptor(path.lexically_normal().string())) return spelt;
    std::error_code is_no_link;
    const std::filesystem::path next = std::filesystem::read_symlink(path, is_no_link);
    if (is_no_link) return std::nullopt;
    path = path.parent_path() / next;
  }
  return std::nullopt;
}

std::optional<std::string> stream_into(const std::filesystem::path& file) {
  struct stat named {
  }, stream{};
  if (::stat(file.c_str(), &named) != 0 || !S_ISREG(named.st_mode)) return std::nullopt;
  for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) {
    const bool is_open = ::fstat(descriptor, &stream) == 0;
    if (!is_open || stream.st_dev != named.st_dev || stream.st_ino != named.st_ino) continue;
    return descriptor == STDOUT_FILENO ? "standard output" : "standard error";
  }
  return std::nullopt;
}

void require_open(const std::filesystem::path& file) {
  const std::optional<int> named = named_descriptor(file);
  if (!named) return;
  const int flags = ::fcntl(*named, F_GETFL);
  if (flags < 0) refuse_output(file, "no such descriptor is open");
  if ((flags & O_ACCMODE) == O_RDONLY) refuse_output(file, "it is open for reading only");
}

void write_into(const std::filesystem::path& file, std::string_view content) {
  const int descriptor = opened(file);
  const int error = descriptor < 0 ? errno : write_all(descriptor, content);
  if (descriptor >= 0) ::close(descriptor);
  if (error != 0) refuse_output(file, std::generic_category().message(error));
}

int write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t count = ::write(descriptor, content.data(), content.size());
    if (count < 0 && errno != EINTR) return errno;
    if (count > 0) content.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

}  // namespace torquewright::io
