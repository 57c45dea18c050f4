// SPDX-License-Identifier: Apache-2.0
#include "identification/log/spill_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

#include "io/faults/spec_error.hpp"

namespace torquewright::identification {
namespace {

std::filesystem::path folder() {
  std::error_code failed;
  const std::filesystem::path path = std::filesystem::temp_directory_path(failed);
  if (!failed) return path;
  throw io::SpecError({{"TMPDIR", "",
                        "a long log is held in the folder that it names, which cannot be used: " +
                            failed.message()}});
}

[[noreturn]] void refuse_disk(const char* what) {
  throw io::SpecError({{folder().string(), "",
                        std::string("cannot hold a long log (8 bytes for each number of it): ") +
                            what + "; TMPDIR names another folder"}});
}

off_t bytes(std::size_t numbers) { return static_cast<off_t>(numbers * sizeof(double)); }

/// Calls until all is done: the system may do a part, or be interrupted.
template <typename Call>
void transfer(std::size_t count, const Call& call) {
  std::size_t done = 0;
  while (done < count) {
    const ssize_t part = call(done);
    if (part < 0 && errno == EINTR) continue;
    if (part < 0) refuse_disk(std::strerror(errno));
    if (part == 0) refuse_disk("a file of ours is shorter than it was");
    done += static_cast<std::size_t>(part);
  }
}

}  // namespace

SpillFile::SpillFile() {
  file_ = ::open(folder().c_str(), O_RDWR | O_TMPFILE | O_CLOEXEC, 0600);
  if (file_ >= 0) return;
  // Not every file system holds a file without a name.
  std::string name = (folder() / "torquewright-log-XXXXXX").string();
  file_ = mkstemp(name.data());
  if (file_ < 0) refuse_disk(std::strerror(errno));
  unlink(name.c_str());  // nobody else finds it, and nothing is left behind
}

SpillFile::~SpillFile() { close(file_); }

std::size_t SpillFile::append(std::span<const double> values) {
  const std::size_t place = end_;
  write(place, values);
  end_ += values.size();
  return place;
}

void SpillFile::write(std::size_t place, std::span<const double> values) {
  const char* const from = reinterpret_cast<const char*>(values.data());
  const std::size_t count = values.size_bytes();
  transfer(count, [&](std::size_t done) {
    return pwrite(file_, from + done, count - done, bytes(place) + static_cast<off_t>(done));
  });
}

void SpillFile::read(std::size_t place, std::span<double> values) const {
  char* const into = reinterpret_cast<char*>(values.data());
  const std::size_t count = values.size_bytes();
  transfer(count, [&](std::size_t done) {
    return pread(file_, into + done, count - done, bytes(place) + static_cast<off_t>(done));
  });
}

}  // namespace torquewright::identification
