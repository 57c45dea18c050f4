// SPDX-License-Identifier: Apache-2.0
#include "io/file_session.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <mutex>
#include <set>
#include <utility>

#include "io/refusal.hpp"

namespace torquewright::io {
namespace {

/// What a file is, whatever it is called.
using Identity = std::pair<dev_t, ino_t>;

struct Inputs {
  std::mutex mutex;
  bool is_open = false;  ///< A session lasts.
  std::set<Identity> files;
};

Inputs& inputs() {
  static Inputs all;
  return all;
}

void remember(const struct stat& status) {
  if (!S_ISREG(status.st_mode)) return;  // a device gives and takes whatever comes
  const std::lock_guard lock(inputs().mutex);
  if (inputs().is_open) inputs().files.emplace(status.st_dev, status.st_ino);
}

bool is_remembered(const struct stat& status) {
  const std::lock_guard lock(inputs().mutex);
  return inputs().files.contains({status.st_dev, status.st_ino});
}

/// A pipe that the shell or the system made has a writer already.
bool is_waited_for(const std::filesystem::path& file, const struct stat& status) {
  const std::string name = file.string();
  return S_ISFIFO(status.st_mode) && !name.starts_with("/dev/fd/") && name != "/dev/stdin" &&
         !(name.starts_with("/proc/") && name.find("/fd/") != std::string::npos);
}

/// Whether a byte, or the writer's end, comes in time: what all pipes are waited for is no more
/// than that for one.
bool has_writer(int descriptor) {
  using std::chrono::milliseconds;
  using Clock = std::chrono::steady_clock;
  static std::atomic<milliseconds::rep> left_ms = 1000 * kWriterPatience_s;
  struct pollfd wait {
    descriptor, POLLIN, 0
  };
  const auto start = Clock::now();
  const auto most_ms = std::max<milliseconds::rep>(0, left_ms);
  const bool is_there = ::poll(&wait, 1, static_cast<int>(most_ms)) > 0;
  left_ms -= std::chrono::duration_cast<milliseconds>(Clock::now() - start).count();
  return is_there;
}

}  // namespace

FileSession::FileSession() {
  const std::lock_guard lock(inputs().mutex);
  inputs().is_open = true;
}

FileSession::~FileSession() {
  const std::lock_guard lock(inputs().mutex);
  inputs().is_open = false;
  inputs().files.clear();
}

// Not blocking: opening a named pipe would wait for its writer.
InputFile::InputFile(const std::filesystem::path& file)
    : descriptor_(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
  if (descriptor_ < 0) refuse_unreadable(file.string(), errno);
  try {
    if (::fstat(descriptor_, &status_) != 0) refuse_unreadable(file.string(), errno);
    if (S_ISDIR(status_.st_mode)) refuse(file.string(), "is a folder, must be a file");
    if (is_waited_for(file, status_) && !has_writer(descriptor_)) {
      refuse(file.string(), fmt::format("is a named pipe, and nobody wrote into it within {} s",
                                        kWriterPatience_s));
    }
    ::fcntl(descriptor_, F_SETFL, ::fcntl(descriptor_, F_GETFL) & ~O_NONBLOCK);
    remember(status_);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

InputFile::~InputFile() { ::close(descriptor_); }

bool is_input(const std::filesystem::path& file) {
  struct stat status {};
  return ::stat(file.c_str(), &status) == 0 && is_remembered(status);
}

bool is_input(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && is_remembered(status);
}

}  // namespace torquewright::io
