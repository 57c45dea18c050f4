// SPDX-License-Identifier: Apache-2.0
#include "io/file_bytes.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "io/refusal.hpp"

namespace torquewright::io {
namespace {

/// An open file; closes itself.
class OpenFile {
 public:
  explicit OpenFile(const std::filesystem::path& file)
      : descriptor_(::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (descriptor_ < 0) refuse_unreadable(file.string(), errno);
  }
  ~OpenFile() { ::close(descriptor_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

void check_status(const std::filesystem::path& file, const OpenFile& open) {
  struct stat status {};
  if (::fstat(open.descriptor(), &status) != 0) refuse_unreadable(file.string(), errno);
  if (S_ISDIR(status.st_mode)) refuse(file.string(), "is a folder, must be a file");
  if (status.st_size > static_cast<off_t>(kMaxFileBytes)) {
    refuse(file.string(),
           fmt::format("holds {} bytes, more than the allowed 64 MiB", status.st_size));
  }
}

}  // namespace

std::string read_file_bytes(const std::filesystem::path& file) {
  const OpenFile open(file);
  check_status(file, open);
  std::string bytes;
  std::string chunk(std::size_t{1} << 16, '\0');
  while (true) {
    const ssize_t count = ::read(open.descriptor(), chunk.data(), chunk.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse_unreadable(file.string(), errno);
    if (count == 0) return bytes;
    bytes.append(chunk, 0, static_cast<std::size_t>(count));
    // Pipes and devices do not tell their size beforehand.
    if (bytes.size() > kMaxFileBytes) refuse(file.string(), "holds more than the allowed 64 MiB");
  }
}

}  // namespace torquewright::io
