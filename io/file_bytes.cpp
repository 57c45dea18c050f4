// SPDX-License-Identifier: Apache-2.0
#include "io/file_bytes.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>

#include "io/file_session.hpp"
#include "io/refusal.hpp"

namespace torquewright::io {
namespace {

void check_size(const std::filesystem::path& file, const InputFile& open) {
  if (open.status().st_size <= static_cast<off_t>(kMaxFileBytes)) return;
  refuse(file.string(),
         fmt::format("holds {} bytes, more than the allowed 64 MiB", open.status().st_size));
}

}  // namespace

std::string read_file_bytes(const std::filesystem::path& file) {
  const InputFile open(file);
  check_size(file, open);
  std::string bytes;
  std::string chunk(std::size_t{1} << 16, '\0');
  while (true) {
    const ssize_t count = ::read(open.descriptor(), chunk.data(), chunk.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse_unreadable(file.string(), errno);
    if (count == 0) break;
    bytes.append(chunk, 0, static_cast<std::size_t>(count));
    // Pipes and devices do not tell their size beforehand.
    if (bytes.size() > kMaxFileBytes) refuse(file.string(), "holds more than the allowed 64 MiB");
  }
  if (!S_ISREG(open.status().st_mode)) remember_names(file, bytes);
  return bytes;
}

}  // namespace torquewright::io
