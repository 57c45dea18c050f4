// SPDX-License-Identifier: Apache-2.0
#include "io/files/file_session.hpp"

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
#include <string>
#include <utility>
#include <vector>

#include "io/faults/refusal.hpp"
#include "io/files/file_limit.hpp"
#include "io/files/named_files.hpp"

namespace torquewright::io {
namespace {

/// What a file is, whatever it is called.
using Identity = std::pair<dev_t, ino_t>;

struct Inputs {
  std::mutex mutex;
  bool is_open = false;  ///< A session lasts.
  std::set<Identity> files;
  std::vector<ReadFile> read;
  std::vector<std::filesystem::path> not_followed;  ///< Of those, what they name is not among them.
};

Inputs& inputs() {
  static Inputs all;
  return all;
}

/// With the lock held.
void add(const std::filesystem::path& file, const struct stat& status) {
  if (inputs().files.emplace(status.st_dev, status.st_ino).second) {
    inputs().not_followed.push_back(file);
  }
}

void remember(const std::filesystem::path& file, const struct stat& status) {
  if (!S_ISREG(status.st_mode)) return;  // a device gives and takes whatever comes
  const std::lock_guard lock(inputs().mutex);
  if (!inputs().is_open) return;
  inputs().read.push_back({file, status});
  add(file, status);
}

/// With the lock held.
void forget() {
  inputs().files.clear();
  inputs().not_followed.clear();
  inputs().read.clear();
}

/// With the lock held: those that are files. A pipe or a device has nothing to lose.
void add_named(const std::vector<std::filesystem::path>& files) {
  for (const std::filesystem::path& file : files) {
    struct stat status {};
    if (::stat(file.c_str(), &status) == 0 && S_ISREG(status.st_mode)) add(file, status);
  }
}

bool begins_as_document(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != text.npos && text[first] == '{';
}

/// A document's text; empty where it is none, as a log of any length, or cannot be read.
std::string document_text(const std::filesystem::path& file) {
  std::string text;
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return text;
  std::string chunk(std::size_t{1} << 16, '\0');
  while (text.size() <= kMaxFileBytes) {
    const ssize_t count = ::read(descriptor, chunk.data(), chunk.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    text.append(chunk, 0, static_cast<std::size_t>(count));
    if (!begins_as_document(text)) text.clear();
    if (text.empty()) break;
  }
  ::close(descriptor);
  return text;
}

/// With the lock held: whatever the inputs name becomes an input, and what that names, without end.
void follow_names() {
  std::vector<std::filesystem::path>& left = inputs().not_followed;
  while (!left.empty()) {
    const std::filesystem::path file = std::move(left.back());
    left.pop_back();
    add_named(files_named_in(document_text(file), file));
  }
}

/// What the inputs name is looked at only where a file that is there would be replaced.
bool is_remembered(const struct stat& status) {
  if (!S_ISREG(status.st_mode)) return false;
  const std::lock_guard lock(inputs().mutex);
  follow_names();
  return inputs().files.contains({status.st_dev, status.st_ino});
}

/// What is said on standard error comes before anything is known of the rest.
void refuse_messages_into(const struct stat& input) {
  struct stat messages {};
  const std::lock_guard lock(inputs().mutex);
  if (!inputs().is_open || !S_ISREG(input.st_mode)) return;
  if (::fstat(STDERR_FILENO, &messages) != 0 || messages.st_dev != input.st_dev ||
      messages.st_ino != input.st_ino) {
    return;
  }
  refuse("standard error", "leads into an input, which would be lost");
}

/// A pipe that the shell or the system made has a writer already, and who types is left the time.
bool is_waited_for(const std::filesystem::path& file, const struct stat& status) {
  const std::string name = file.string();
  return (S_ISFIFO(status.st_mode) || S_ISCHR(status.st_mode)) && !name.starts_with("/dev/fd/") &&
         name != "/dev/stdin" &&
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
  forget();
}

std::vector<ReadFile> files_read() {
  const std::lock_guard lock(inputs().mutex);
  return inputs().read;
}

void forget_files_read() {
  const std::lock_guard lock(inputs().mutex);
  forget();
}

// Not blocking: opening a named pipe would wait for its writer.
InputFile::InputFile(const std::filesystem::path& file)
    : descriptor_(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {
  if (descriptor_ < 0) refuse_unreadable(file.string(), errno);
  try {
    if (::fstat(descriptor_, &status_) != 0) refuse_unreadable(file.string(), errno);
    if (S_ISDIR(status_.st_mode)) refuse(file.string(), "is a folder, must be a file");
    if (is_waited_for(file, status_) && !has_writer(descriptor_)) {
      refuse(file.string(),
             fmt::format("is a {}, and nobody wrote into it within {} s",
                         S_ISCHR(status_.st_mode) ? "device" : "named pipe", kWriterPatience_s));
    }
    // What looks like a file and waits (/proc/kmsg) fails at its end.
    const bool may_wait = !S_ISREG(status_.st_mode);
    if (may_wait) ::fcntl(descriptor_, F_SETFL, ::fcntl(descriptor_, F_GETFL) & ~O_NONBLOCK);
    remember(file, status_);
    refuse_messages_into(status_);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

InputFile::~InputFile() { ::close(descriptor_); }

void remember_names(const std::filesystem::path& document, std::string_view text) {
  const std::lock_guard lock(inputs().mutex);
  if (inputs().is_open) add_named(files_named_in(text, document));
}

bool is_input(const std::filesystem::path& file) {
  struct stat status {};
  return ::stat(file.c_str(), &status) == 0 && is_remembered(status);
}

bool is_input(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && is_remembered(status);
}

}  // namespace torquewright::io
