// SPDX-License-Identifier: Apache-2.0
#include "io/files/file_bytes.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "io/faults/refusal.hpp"
#include "io/files/file_session.hpp"
#include "io/files/long_file.hpp"

namespace torquewright::io {
namespace {

void check_size(const std::filesystem::path& file, const InputFile& open) {
  if (open.status().st_size <= static_cast<off_t>(kMaxFileBytes)) return;
  refuse(file.string(),
         fmt::format("holds {} bytes, more than the allowed 64 MiB", open.status().st_size));
}

/// The next bytes, in `chunk`; none at the end.
std::string_view read_chunk(const std::filesystem::path& file, const InputFile& open,
                            std::string& chunk) {
  while (true) {
    const ssize_t count = ::read(open.descriptor(), chunk.data(), chunk.size());
    if (count >= 0) return std::string_view(chunk).substr(0, static_cast<std::size_t>(count));
    if (errno != EINTR) refuse_unreadable(file.string(), errno);
  }
}

std::string new_chunk() { return std::string(std::size_t{1} << 16, '\0'); }

}  // namespace

std::string read_file_bytes(const std::filesystem::path& file) {
  const InputFile open(file);
  check_size(file, open);
  std::string bytes;
  std::string chunk = new_chunk();
  while (true) {
    const std::string_view next = read_chunk(file, open, chunk);
    if (next.empty()) break;
    bytes.append(next);
    // Pipes and devices do not tell their size beforehand.
    if (bytes.size() > kMaxFileBytes) refuse(file.string(), "holds more than the allowed 64 MiB");
  }
  if (!S_ISREG(open.status().st_mode)) remember_names(file, bytes);
  return bytes;
}

bool holds(const std::filesystem::path& file, std::string_view content) {
  return holds(file, [&](const TextSink& sink) { sink(content); });
}

bool holds(const std::filesystem::path& file, const TextSource& text) {
  const InputFile open(file);
  std::string chunk = new_chunk();
  std::string_view unread;
  bool is_same = true;
  const auto compare = [&](std::string_view piece) {
    while (is_same && !piece.empty()) {
      if (unread.empty()) unread = read_chunk(file, open, chunk);
      const std::size_t length = std::min(unread.size(), piece.size());
      is_same = length > 0 && unread.substr(0, length) == piece.substr(0, length);
      unread.remove_prefix(length);
      piece.remove_prefix(length);
    }
  };
  text(compare);
  return is_same && unread.empty() && read_chunk(file, open, chunk).empty();
}

}  // namespace torquewright::io
