// SPDX-License-Identifier: Apache-2.0
#include "io/files/own_arguments.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>

namespace torquewright::io {
namespace {

std::string command_line() {
  const int descriptor = ::open("/proc/self/cmdline", O_RDONLY | O_CLOEXEC);
  std::string bytes;
  std::array<char, 4096> chunk;
  while (descriptor >= 0) {
    const ssize_t count = ::read(descriptor, chunk.data(), chunk.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    bytes.append(chunk.data(), static_cast<std::size_t>(count));
  }
  if (descriptor >= 0) ::close(descriptor);
  return bytes;
}

}  // namespace

std::vector<std::string> own_arguments() {
  std::vector<std::string> words;
  const std::string bytes = command_line();
  std::string_view rest = bytes;
  for (std::size_t end = rest.find('\0'); end != std::string_view::npos; end = rest.find('\0')) {
    words.emplace_back(rest.substr(0, end));
    rest.remove_prefix(end + 1);
  }
  return words;
}

}  // namespace torquewright::io
