// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/program/fork_channel.hpp"

#include <sys/socket.h>

#include <cerrno>
#include <string>
#include <string_view>

namespace torquewright::fuzz {

bool send_bytes(int channel, const void* bytes, std::size_t count) {
  const char* next = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t sent = ::send(channel, next, count, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    next += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool receive_bytes(int channel, void* bytes, std::size_t count) {
  char* next = static_cast<char*>(bytes);
  while (count > 0) {
    const ssize_t received = ::recv(channel, next, count, 0);
    if (received < 0 && errno == EINTR) continue;
    if (received <= 0) return false;
    next += received;
    count -= static_cast<std::size_t>(received);
  }
  return true;
}

bool send(int channel, const Words& request) {
  std::string bytes;
  for (const std::string& word : request) (bytes += word.c_str()) += '\0';
  return send_value(channel, bytes.size()) && send_bytes(channel, bytes.data(), bytes.size());
}

bool receive(int channel, Words& request) {
  std::size_t size = 0;
  if (!receive_value(channel, size)) return false;
  std::string bytes(size, '\0');
  if (!receive_bytes(channel, bytes.data(), size)) return false;
  request.clear();
  for (std::string_view rest = bytes; !rest.empty();) {
    const std::size_t end = rest.find('\0');
    request.emplace_back(rest.substr(0, end));
    rest.remove_prefix(end + 1);
  }
  return true;
}

}  // namespace torquewright::fuzz
