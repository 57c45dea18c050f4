// SPDX-License-Identifier: Apache-2.0
#include "io/files/plain_bytes.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "io/faults/refusal.hpp"

namespace torquewright::io {
namespace {

constexpr std::size_t kFirstBytes = 256;

}  // namespace

PlainBytes::PlainBytes(const std::filesystem::path& file) : file_(file.string()), input_(file) {
  const struct stat& status = input_.status();
  if (S_ISREG(status.st_mode)) size_bytes_ = static_cast<double>(status.st_size);
  first_.resize(kFirstBytes);
  first_.resize(read_from_file(first_.data(), first_.size()));
}

std::size_t PlainBytes::read(char* to, std::size_t most) {
  if (given_of_first_ == first_.size()) return read_from_file(to, most);
  const std::size_t count = std::min(most, first_.size() - given_of_first_);
  std::memcpy(to, first_.data() + given_of_first_, count);
  given_of_first_ += count;
  return count;
}

std::size_t PlainBytes::read_from_file(char* to, std::size_t most) {
  while (true) {
    const ssize_t count = ::read(input_.descriptor(), to, most);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse_unreadable(file_, errno);
    hash_.add({to, static_cast<std::size_t>(count)});
    bytes_read_ += static_cast<double>(count);
    return static_cast<std::size_t>(count);
  }
}

double PlainBytes::share_read() const {
  return is_plain_file() ? std::min(1.0, bytes_read_ / size_bytes_) : 0.0;
}

}  // namespace torquewright::io
